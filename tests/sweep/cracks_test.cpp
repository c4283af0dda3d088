// Cracks: the exact test has none, a faulty test has some, and a removed hit is one.
#include <cmath>

#include <glm/geometric.hpp>

#include "model/unit/raygen/raygen.hpp"
#include "sim/explore/sweep/cracks.hpp"
#include "tests/sweep/small_sweeps.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct Traced {
    Scene scene;
    Job job;
    RecordedFrame frame;
    std::uint64_t cracks(const std::vector<Closest>& hits) const {
        return sweep::count_cracks(scene, job, hits, 2);
    }
};

Traced traced(const std::string& name, FrameSize size, Config config = named_config("default")) {
    Traced t{scene_with_camera(name), {}, {}};
    t.job = make_job(t.scene, *t.scene.camera, size, config);
    t.frame = record_frame(t.job, t.job.frame, 2);
    return t;
}

}   // namespace

TEST_CASE("the exact test lets no ray slip through") {
    for (const std::string name : {"gears:2", "icosphere:4", "mount:4", "rings:1"})
        for (const int bits : {12, 18}) {
            INFO(name << " with " << bits << " bits");
            Config config = named_config("default");
            config.coord_bits = bits;
            const Traced t = traced(name, {96, 72}, config);
            CHECK(t.cracks(t.frame.trace.hits) == 0);
        }
}

TEST_CASE("a missing or farther hit is a crack, a neighbouring or nearer one is not") {
    const Traced t = traced("icosphere:4", {64, 48});
    std::vector<Closest> hits = t.frame.trace.hits;
    const std::size_t at = hits.size() / 2 + 32;
    REQUIRE(hits[at].found);
    const std::uint32_t met = hits[at].prim;
    hits[at].found = false;
    CHECK(t.cracks(hits) == 1);
    hits[at].found = true;
    // Triangles whose plane the ray reaches later, and that do not touch the one it meets, are cracks.
    // Distances of planes are computed in doubles, so doubtful differences are skipped.
    const Vec3i o = t.job.frame.eye, d = pixel_direction(std::uint32_t(at % 64), std::uint32_t(at / 64),
                                                         t.job.frame, t.job.config);
    const auto distance = [&](std::uint32_t triangle) {
        std::array<glm::dvec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3i v = t.job.image.lattice.snap(t.scene.vertices[t.scene.triangles[triangle].vertex[k]]);
            p[k] = {v[0] - o[0], v[1] - o[1], v[2] - o[2]};
        }
        const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
        return glm::dot(n, p[0]) / glm::dot(n, glm::dvec3(d[0], d[1], d[2]));
    };
    const double here = distance(met);
    std::uint64_t cracks = 0, others = 0;
    for (std::uint32_t other = 0; other < t.scene.triangles.size(); other += 7) {
        bool touches = other == met;
        for (const std::uint32_t a : t.scene.triangles[other].vertex)
            for (const std::uint32_t b : t.scene.triangles[met].vertex) touches = touches || a == b;
        const double there = distance(other);
        if (!(std::abs(there - here) > 1e-6 * here)) continue;
        INFO("triangle " << other << " at " << there << ", met one at " << here);
        hits[at].prim = other;
        const bool crack = !touches && there > here;
        CHECK(t.cracks(hits) == std::uint64_t(crack));
        ++(crack ? cracks : others);
    }
    CHECK(cracks > 10);
    CHECK(others > 10);
}

TEST_CASE("a test that rounds lets rays slip through, and the count says so") {
    Config config = named_config("default");
    set_parameter(config, "primitive_test", "truncated", "test");
    const Traced t = traced("gears:2", {192, 144}, config);
    CHECK(t.cracks(t.frame.trace.hits) > 0);
}
