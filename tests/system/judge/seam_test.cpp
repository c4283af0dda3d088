// Seams between instances: they appear where the lines of two instances differ, and nowhere else.
#include <catch2/catch.hpp>

#include <glm/gtc/matrix_transform.hpp>

#include "model/compile/surfaces.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/cause/finished.hpp"
#include "sim/files/image/srgb.hpp"
#include "tests/support/levels/finished_instances.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::seam_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr FrameSize size{96, 72};

/// Returns a wall of adjacent squares, each an instance. `turn` rotates the wall; each square is rotated
/// within it.
PlacedScene wall(const glm::dmat4& turn) {
    constexpr int side = 12;
    PlacedScene scene;
    scene.own.name = "wall";
    scene.own.materials = {coloured({0.8, 0.7, 0.6}, 0, 0), coloured({0.2, 0.3, 0.7}, 0, 0)};
    scene.own.background = {0, 0.5, 0};
    scene.own.lights = {{{3, 5, 30}, glm::dvec3(0.9)}};
    scene.own.camera = Camera{{1, 2, 20}, {0, 0, 0}, {0, 1, 0}, 40};
    SharedMesh square{"square", {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {}, {}};
    square.triangles = {{{0, 1, 2}, 0}, {{0, 2, 3}, 0}};
    scene.meshes.push_back(square);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            glm::dmat4 place = glm::translate(turn, glm::dvec3(x - 5.5, y - 5.5, 0));
            place = glm::rotate(place, glm::radians(90.0) * ((3 * x + 5 * y) % 4), glm::dvec3(0, 0, 1));
            place = glm::scale(place, glm::dvec3(0.5));
            glm::dmat4 leaning(1);   // z is 0, so it changes no corner, but every row of the map
            leaning[2] = {0.3 * ((7 * x + 3 * y) % 5) - 0.6, 0.3 * ((3 * x + 5 * y) % 7) - 0.9, 1, 0};
            scene.instances.push_back({"square", 0, place * leaning, std::uint32_t((x + y) % 2)});
        }
    return scene;
}

Config formats(int coord_bits, int dir_bits) {
    return with(named_config("default"),
                {{"coord_bits", coord_bits}, {"dir_bits", dir_bits}, {"levels", 2}, {"stack_depth", 64}});
}

Judgement judged(const Scene& scene, const Config& config) {
    const Job job = make_job(scene, *scene.camera, size, config);
    const RecordedFrame trace = record_frame(job, job.frame);
    const HitFrame reference = Reference(scene).frame(*scene.camera, size);
    const Picture picture = shade(scene, scaled(job, job.frame, trace.trace.hits));
    return judge({scene, *scene.camera, trace.frame, job.image.lattice, job.config}, job.image,
                 {reference, trace.trace.hits, picture});
}

Judgement judged_finished(const Scene& scene, Config config, const Whitted& settings) {
    config = fitted_config(scene, settings, config);
    const Job job = make_job(scene, *scene.camera, size, config, {}, settings);
    const RecordedFrame trace = record_frame(job, job.frame);
    const WhittedFrame reference = Reference(scene).whitted(*scene.camera, size, settings);
    const Picture picture = picture_from_colours(size, trace.trace.colours);
    const MachineOutput given{trace.trace.hits, trace.trace.colours, trace.trace.signatures};
    return judge_finished({scene, *scene.camera, trace.frame, job.image.lattice, job.config}, job.image,
                          settings, {reference, picture, given}, scaled(job, job.frame, trace.trace.hits));
}

std::uint64_t count(const Judgement& j, PixelCause cause) { return j.causes[std::size_t(cause)]; }

glm::dmat4 slanted() {
    return glm::rotate(glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(0.6, 0.8, 0)), 0.2, glm::dvec3(0, 0, 1));
}

}   // namespace

TEST_CASE("squares that touch show seams, as far as lines are rounded", "[cause][levels]") {
    const Scene scene = flattened(wall(slanted()));
    const Judgement coarse = judged(scene, formats(16, 12)), fine = judged(scene, formats(20, 22));
    for (const Judgement* j : {&coarse, &fine}) {
        CHECK(j->wrong == 0);
        CHECK(j->bugs() == 0);
    }
    CAPTURE(coarse.causes, fine.causes, coarse.seams_apart);
    CHECK(count(coarse, PixelCause::seam) > 3);
    CHECK(count(fine, PixelCause::seam) == 0);
    CHECK(coarse.seams_apart > 0.2);
    CHECK(coarse.seams_apart <= 1);
    CHECK(fine.seams_apart == 0);
}

TEST_CASE("where no map rounds anything there is no seam", "[cause][levels]") {
    PlacedScene scene = wall(slanted());
    const SharedMesh square = scene.meshes[0];
    scene.meshes.clear();
    for (Instance& instance : scene.instances) {   // each square in its place, as a mesh of its own
        SharedMesh mesh = square;
        for (glm::dvec3& v : mesh.vertices) v = glm::dvec3(instance.place * glm::dvec4(v, 1));
        instance.mesh = std::uint32_t(scene.meshes.size()), instance.place = glm::dmat4(1);
        scene.meshes.push_back(std::move(mesh));
    }
    const Judgement j = judged(flattened(scene), formats(16, 12));
    CHECK(j.wrong == 0);
    CHECK(j.bugs() == 0);
    CHECK(count(j, PixelCause::ray_quantisation) > 50);
    CHECK(count(j, PixelCause::seam) == 0);
}

TEST_CASE("one instance has no seam, however coarse its rays are", "[cause][levels]") {
    PlacedScene scene = mixed(false);
    scene.own.vertices.clear(), scene.own.triangles.clear();
    scene.instances = {scene.instances[2]};
    const Judgement j = judged(flattened(scene), formats(16, 12));
    CHECK(j.wrong == 0);
    CHECK(j.bugs() == 0);
    CHECK(count(j, PixelCause::ray_quantisation) > 10);
    CHECK(count(j, PixelCause::seam) == 0);
}

TEST_CASE("finished pictures of squares that touch show seams", "[cause][levels]") {
    Whitted settings;
    settings.depth = 1;
    const Scene scene = flattened(wall(slanted()));
    const Judgement coarse = judged_finished(scene, formats(16, 12), settings);
    CHECK(coarse.wrong == 0);
    CHECK(coarse.bugs() == 0);
    CAPTURE(coarse.causes, coarse.seams_apart);
    CHECK(count(coarse, PixelCause::seam) > 3);
    CHECK(coarse.seams_apart > 0.2);
    CHECK(coarse.seams_apart <= 1);
    const Judgement fine = judged_finished(scene, formats(18, 24), settings);
    CHECK(fine.wrong == 0);
    CHECK(fine.bugs() == 0);
    CHECK(count(fine, PixelCause::seam) <= count(coarse, PixelCause::seam) / 4);
}

}   // namespace rayclock::test::seam_test
