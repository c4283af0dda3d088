// The model's frame equals the exact result for the snapped scene: the same primitive in every pixel, with
// distance and weights as stated.
#include <catch2/catch.hpp>

#include "model/layout/memory_image.hpp"
#include "tests/support/geometry/exact.hpp"
#include "tests/support/machine/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Compares every pixel of a frame with brute force.
void check_exact(const Scene& scene, const Job& job) {
    const ExactScene exact(scene, job.image.lattice);
    const RecordedFrame frame = record_frame(job, job.frame);
    const int time_bits = job.config.dir_bits - 1 + job.config.t_frac_bits;
    const Int beyond = (Int(1) << job.config.t_bits()) - 1;
    std::size_t hits = 0, wrong = 0, wrong_t = 0;
    for (std::size_t i = 0; i < frame.trace.hits.size(); ++i) {
        const Closest& closest = frame.trace.hits[i];
        const int x = int(i % job.frame.width), y = int(i / job.frame.width);
        const ExactHit truth = exact.closest(job.frame.eye, exact_direction(job.frame, x, y, job.config));
        const std::uint32_t prim = closest.found ? closest.prim : no_primitive;
        wrong += prim != truth.primitive;
        if (prim != truth.primitive)
            UNSCOPED_INFO("pixel " << x << "," << y << ": " << prim << ", and truly " << truth.primitive);
        if (truth.primitive == no_primitive) continue;
        ++hits;
        // t is rounded up: t - 1 < 2^k num / den <= t, unless saturated.
        const Int scaled = truth.num << time_bits, t = closest.t;
        wrong_t += !(t == beyond ? (t - 1) * truth.den < scaled
                                 : (t - 1) * truth.den < scaled && scaled <= t * truth.den);
    }
    CHECK(wrong == 0);
    CHECK(wrong_t == 0);
    CHECK(hits > job.size.width * std::size_t(job.size.height) / 50);
}

/// Returns random triangles of all sizes, some with shared corners, some edge-on, some duplicated.
Scene soup(std::uint64_t seed, int triangles) {
    Rng rng(seed);
    const auto coordinate = [&](int steps) { return (rng.below(2 * steps + 1) - steps) / double(steps); };
    Scene scene;
    scene.name = "soup";
    scene.materials.push_back({});
    for (int i = 0; i < triangles; ++i) {
        const double size = i % 3 == 0 ? 0.9 : i % 3 == 1 ? 0.2 : 0.02;
        const glm::dvec3 at{coordinate(8), coordinate(8), coordinate(8)};
        for (int k = 0; k < 3; ++k)
            scene.vertices.push_back(at + size * glm::dvec3{coordinate(4), coordinate(4), coordinate(4)});
        const auto first = std::uint32_t(3 * i);
        scene.triangles.push_back({{first, first + 1, first + 2}, 0});
        if (i % 5 == 4) scene.triangles.push_back({{first - 1, first, first + 2}, 0});
        if (i % 7 == 6) scene.triangles.push_back({{first + 1, first, first + 2}, 0});
    }
    scene.camera = Camera{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40};
    return scene;
}

}   // namespace

TEST_CASE("every pixel holds the primitive that exact arithmetic finds: scenes") {
    const std::string name = GENERATE("teapot:3", "icosphere:3", "cornell", "tetra:4");
    const std::string config = GENERATE("default", "small", "narrow", "broad");
    INFO(name << " on " << config);
    const Shot shot = make_shot(name, {32, 24}, quick_config(config));
    check_exact(shot.scene, shot.job);
}

TEST_CASE("every pixel holds the primitive that exact arithmetic finds: random triangles") {
    const int seed = GENERATE(range(1, 9));
    const std::string config = GENERATE("default", "small", "narrow", "broad");
    INFO("soup " << seed << " on " << config);
    const Scene scene = soup(std::uint64_t(seed), 60 + 20 * seed);
    check_exact(scene, make_job(scene, *scene.camera, {32, 24}, quick_config(config)));
}

TEST_CASE("every pixel holds the primitive that exact arithmetic finds: camera on vertices, edges and axes") {
    // From a lattice point of the mesh's symmetry planes, pixel centres lie on edges, and directions have
    // zero components.
    const glm::dvec3 eye = GENERATE(glm::dvec3{0, 0, 3}, glm::dvec3{3, 0, 0}, glm::dvec3{0, -3, 0},
                                    glm::dvec3{0, 0, 0}, glm::dvec3{2, 2, 2});
    const std::string name = GENERATE("icosphere:2", "tetra:3");
    Shot shot = make_shot(name, {33, 33}, named_config("default"));
    const glm::dvec3 at = eye == glm::dvec3{0} ? glm::dvec3{0, 0, -1} : glm::dvec3{0};
    const glm::dvec3 up = std::abs(eye.y) > 2.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    shot.scene.camera = Camera{eye, at, up, 40};
    INFO(name << " from " << eye.x << " " << eye.y << " " << eye.z);
    for (const char* config : {"default", "narrow"})
        check_exact(shot.scene, make_job(shot.scene, *shot.scene.camera, {33, 33}, quick_config(config)));
}
