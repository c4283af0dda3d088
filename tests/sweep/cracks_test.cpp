// Cracks: none with the exact test; a test that is made wrong has some, and a hit that was taken away is one.
#include "sim/sweep/cracks.hpp"
#include "tests/sweep/support.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct Traced {
    Scene scene;
    Job job;
    FrameTrace frame;
    std::uint64_t cracks(const std::vector<Closest>& hits) const { return sweep::count_cracks(scene, job, hits, 2); }
};

Traced traced(const std::string& name, FrameSize size, Config config = named_config("default")) {
    Traced t{scene_with_camera(name), {}, {}};
    t.job = make_job(t.scene, *t.scene.camera, size, config);
    t.frame = record_frame(t.job, t.job.frame, 2);
    return t;
}

} // namespace

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

TEST_CASE("a hit that is taken away or put behind is a crack, one beside or before it is none") {
    const Traced t = traced("icosphere:4", {64, 48});
    std::vector<Closest> hits = t.frame.trace.hits;
    std::size_t at = hits.size() / 2 + 32;
    REQUIRE(hits[at].found);
    const std::uint32_t met = hits[at].prim;
    hits[at].found = false;
    CHECK(t.cracks(hits) == 1);
    hits[at].found = true;
    // The sphere is closed: of its triangles those whose plane the ray reaches later, and that do not touch the one met, are cracks.
    std::uint64_t cracks = 0, touching = 0;
    for (std::uint32_t other = 0; other < t.scene.triangles.size(); ++other) {
        hits[at].prim = other;
        const std::uint64_t counted = t.cracks(hits);
        bool touches = other == met;
        for (const std::uint32_t a : t.scene.triangles[other].vertex)
            for (const std::uint32_t b : t.scene.triangles[met].vertex) touches = touches || a == b;
        if (touches) CHECK(counted == 0);
        touching += touches;
        cracks += counted;
        if (other > 300) break;
    }
    CHECK(cracks > 0);
    (void)touching;
}

TEST_CASE("a test that rounds lets rays slip through, and the count says so") {
    Config config = named_config("default");
    set_parameter(config, "primitive_test", "truncated", "test");
    const Traced t = traced("gears:2", {192, 144}, config);
    CHECK(t.cracks(t.frame.trace.hits) > 0);
}
