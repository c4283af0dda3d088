// Extreme cameras: from 1 to 175 degrees, tall and wide pictures, and an eye far away, very near, or in a
// narrow gap. Every pixel is exact, no distance saturates, boxes behind a hit are skipped, and the cycles
// follow from the visits.
#include <catch2/catch.hpp>

#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "sim/judge/oracle/extra_visits.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/cause/exact_answers.hpp"
#include "sim/judge/paths/camera.hpp"
#include "sim/view/report/json.hpp"
#include "tests/support/geometry/exact.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::extreme_cameras_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// A reciprocal of R bits errs by 2^(1-R) of the distance, so the machine enters a few more boxes than the
/// ray meets. This is the largest share of visits for R = 16 and an eye near the scene.
constexpr double most_extra = 0.02;

Scene loaded(const std::string& name) {
    Scene scene = make_builtin(name);
    if (!scene.camera) scene.camera = fit_camera(scene, 1);
    return scene;
}

/// Requires that every answer is the only correct one, and that none reaches the end of t's range or exceeds
/// half of it.
void check_answers(const Scene& scene, const Job& job, const RecordedFrame& frame) {
    const ExactAnswers truth(scene, job.image.lattice, job.config);
    std::size_t wrong = 0, other_direction = 0, beyond = 0, short_directions = 0;
    for (std::size_t i = 0; i < frame.trace.hits.size(); ++i) {
        const int x = int(i % job.frame.width), y = int(i / job.frame.width);
        const Closest& answer = frame.trace.hits[i];
        const Vec3i d = rayclock::exact_direction(job.frame, job.config, {}, x, y, 0);
        other_direction += d != test::exact_direction(job.frame, x, y, job.config);
        short_directions +=
            std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])}) < 1 << (job.config.dir_bits - 2);
        wrong += !same_answer(answer, truth.answer(truth.pixel(job.frame, x, y)));
        beyond += answer.t >> (job.config.t_bits() - 1);
    }
    CHECK(other_direction == 0);
    CHECK(short_directions == 0);
    CHECK(wrong == 0);
    CHECK(beyond == 0);
}

/// Requires that boxes behind a hit are skipped, except for this share of the visits.
void check_visits(const Job& job, const RecordedFrame& frame, double extra_part) {
    const ExtraVisits extra = extra_visits(job.image, job.frame, job.config);
    CHECK(extra.boxes_lost + extra.t_late + extra.other_hits == 0);
    CHECK(extra.machine.visits == frame.trace.visits);
    CHECK(double(extra.machine.visits) <= (1 + extra_part) * double(extra.exact.visits) + 8);
}

/// With memory that never keeps a unit waiting for long, the machine does a visit or a test in nearly every
/// cycle.
void check_cycles(const Job& job, const RecordedFrame& frame) {
    const Config ideal = with(job.config, {{"dram", 0}, {"mem_latency", 4}, {"mem_interval", 1}});
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(job, job.frame));
    const std::uint64_t cycles = replay(ideal, default_khz, frames)[0].cycles;
    const double work = double(
        std::max({frame.trace.visits, frame.trace.triangle_tests, std::uint64_t(frame.trace.hits.size())}));
    CAPTURE(cycles, work);
    // The last ray's path through an empty machine, and cold caches.
    CHECK(double(cycles) <= 1.25 * work + 2500);
}

void check_camera(const Scene& scene, const Camera& camera, FrameSize size, const Config& config,
                  double extra_part = most_extra) {
    const Job job = make_job(scene, camera, size, config);
    const RecordedFrame frame = record_frame(job, job.frame);
    check_answers(scene, job, frame);
    check_visits(job, frame, extra_part);
    if (config.raygen_queue >= 16) check_cycles(job, frame);   // queues of two make every unit wait
}

const std::vector<double> angles{1, 110, 140, 160, 175};
const std::vector<FrameSize> sizes{{48, 36}, {24, 64}, {120, 10}};

/// Two large sheets of 18 x 18 squares at distance `width`, and a box of teeth around them.
Scene gap(double width) {
    Scene scene;
    scene.name = "gap";
    scene.materials.push_back({});
    constexpr int side = 18;
    const auto add = [&](const auto& place) {
        const auto first = std::uint32_t(scene.vertices.size());
        for (int y = 0; y <= side; ++y)
            for (int x = 0; x <= side; ++x)
                scene.vertices.push_back(place(2.0 * x / side - 1, 2.0 * y / side - 1));
        for (std::uint32_t y = 0; y < side; ++y)
            for (std::uint32_t x = 0; x < side; ++x) {
                const std::uint32_t a = first + y * (side + 1) + x, b = a + 1, c = a + side + 1;
                scene.triangles.push_back({{a, b, c}, 0});
                scene.triangles.push_back({{b, c + 1, c}, 0});
            }
    };
    for (const double z : {-0.5 * width, 0.5 * width})
        add([z](double u, double v) { return glm::dvec3{u, v, z}; });
    for (const double z : {-1.0, 1.0})
        add([z](double u, double v) { return glm::dvec3{u, v, z * (1 + 0.2 * u * u - 0.3 * v * v)}; });
    return scene;
}

}   // namespace

TEST_CASE(
    "wide and narrow cameras are exact in every pixel, no distance saturates, and visits explain the "
    "cycles") {
    const std::string name = GENERATE("gears:2", "cornell", "icosphere:3", "balls:1");
    const std::string config = GENERATE("default", "narrow");
    Scene scene = loaded(name);
    for (const double angle : angles)
        for (const FrameSize size : sizes) {
            scene.camera->fov_degrees = angle;
            INFO(name << " on " << config << ", " << angle << " degrees, " << size.width << " x "
                      << size.height);
            check_camera(scene, *scene.camera, size, quick_config(config),
                         config == "narrow" ? 0.1 : most_extra);   // R = 8
        }
}

TEST_CASE("a picture at 140 degrees has the error of one at 40 degrees") {
    for (const char* name : {"gears:2", "balls:1", "cornell"}) {
        Scene scene = loaded(name);
        const double scale = glm::distance(scene.camera->eye, scene.camera->at);
        for (const double angle : {40.0, 110.0, 140.0, 160.0, 175.0}) {
            scene.camera->fov_degrees = angle;
            const FrameSize size{96, 72};
            const Job job = make_job(scene, *scene.camera, size, named_config("default"));
            const FrameError error = frame_error(scene, hits_of(job, record_frame(job, job.frame)),
                                                 Reference(scene).frame(*scene.camera, size));
            INFO(name << ", " << angle << " degrees: " << error.max_abs_depth << " over "
                      << error.depth_pixels << " pixels");
            CHECK(error.max_abs_depth <= 1e-3 * scale);
            CHECK(error.pixels_other_primitive <= error.pixels / 400);
            CHECK(error.depth_pixels > 0);
        }
    }
}

TEST_CASE("model and RTL agree for wide and narrow cameras", "[long]") {
    const double angle = GENERATE(1.0, 110.0, 140.0, 160.0, 175.0);
    const std::string config = GENERATE("default", "small", "narrow", "broad");
    const FrameSize size = angle == 140   ? FrameSize{24, 64}
                           : angle == 160 ? FrameSize{120, 10}
                                          : FrameSize{48, 36};
    INFO(angle << " degrees on " << config);
    Scene scene = loaded("gears:2");
    scene.camera->fov_degrees = angle;
    check_lockstep(make_job(scene, *scene.camera, size, quick_config(config)));
}

TEST_CASE("model and RTL agree from far away, very near, and in a narrow gap") {
    const Scene balls = loaded("balls:1"), narrow_gap = gap(1e-3);
    const glm::dvec3 at = balls.camera->at, way = balls.camera->eye - at;
    const std::string config = GENERATE("default", "narrow");
    INFO(config);
    const Config machine = quick_config(config);
    if (config != "narrow")
        check_lockstep(
            make_job(balls, Camera{at + 300.0 * way, at, balls.camera->up, 0.1}, {40, 30}, machine));
    check_lockstep(
        make_job(balls, Camera{at + glm::dvec3{1e-3, 0, 0}, at, balls.camera->up, 150}, {40, 30}, machine));
    check_lockstep(
        make_job(narrow_gap, Camera{{0.01, 0.02, 0}, {1, 0.4, 0}, {0, 0, 1}, 140}, {40, 30}, machine));
}

TEST_CASE("an eye far away or very near is exact in every pixel, and visits explain the cycles") {
    const std::string name = GENERATE("gears:2", "cornell", "balls:1");
    const Scene scene = loaded(name);
    const Bounds box = bounds(scene);
    const double side = glm::length(box.hi - box.lo);
    const glm::dvec3 at = 0.5 * (box.lo + box.hi), way = glm::normalize(glm::dvec3{0.6, 0.5, 1});
    for (const double times : {1e3, 1e6}) {
        const Camera far{at + times * side * way, at, {0, 1, 0}, times < 1e5 ? 0.08 : 1e-4};
        for (const int bits : {18, 20}) {
            INFO(name << " from " << times << " times its size, " << bits << " bits");
            const Config config = with(named_config("default"), {{"coord_bits", bits}});
            try {
                // A reciprocal's error is then a large part of the scene, or all of it.
                check_camera(scene, far, {40, 30}, config, times < 1e5 ? 0.3 : 2);
                CHECK((times < 1e5 || bits == 20));   // a lattice of 18 bits has fewer than a million steps
            } catch (const UserError& e) {
                CHECK(times > 1e5);
                CHECK_THAT(e.what(), Catch::Contains("vanish on a lattice") &&
                                         Catch::Contains("an eye closer to the scene"));
            }
        }
    }
    const Triangle& t = scene.triangles[scene.triangles.size() / 2];
    const glm::dvec3 a = scene.vertices[t.vertex[0]], b = scene.vertices[t.vertex[1]],
                     c = scene.vertices[t.vertex[2]];
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a)), point = (a + b + c) / 3.0;
    for (const double to : {1.0, -1.0})
        for (const double angle : angles) {
            const Camera near{point + to * 1e-3 * side * normal, point + 0.3 * (b - a), c - b, angle};
            INFO(name << " from a thousandth of its size, " << angle << " degrees, side " << to);
            check_camera(scene, near, {40, 30}, named_config("default"));
        }
}

TEST_CASE("an eye in a narrow gap is exact in every pixel, and visits explain the cycles") {
    for (const double width : {1e-2, 1e-3, 1e-4}) {   // the lattice's pitch is about 1e-5
        const Scene scene = gap(width);
        for (const double angle : angles)
            for (const FrameSize size : sizes) {
                INFO("gap of " << width << ", " << angle << " degrees, " << size.width << " x "
                               << size.height);
                check_camera(scene, Camera{{0.01, 0.02, 0}, {1, 0.4, 0}, {0, 0, 1}, angle}, size,
                             named_config("default"));
            }
    }
}

}   // namespace rayclock::test::extreme_cameras_test
