// Textured instances in whole pictures, with one level and with two: the judge accepts every ray and colour,
// no pixel differs from the reference without a cause, and the RTL equals the model.
#include <catch2/catch.hpp>

#include "model/compile/surfaces.hpp"
#include "model/engine/check.hpp"
#include "sim/load/load.hpp"
#include "tests/support/machine/build_all.hpp"
#include "tests/support/machine/frames.hpp"
#include "tests/support/machine/textured_pictures.hpp"
#include "tests/support/scenes/textured_cubes.hpp"

namespace rayclock::test::textured_instances_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Returns a chip with two levels. `fast` has fast timing, a pass every eight cycles and short texels.
Config chip(const Scene& scene, const Whitted& settings, bool is_fast) {
    Config c = named_config(is_fast ? "ulx3s-shaded" : "default");
    c.levels = 2, c.contexts = 16, c.stack_depth = 64;
    if (is_fast) c.texels = TexelFormat::rgb565;
    c.name = is_fast ? "fast" : "plain";
    c = fitted_config(scene, settings, c);
    check_config(c, c.name);
    return c;
}

const Whitted one_bounce{.depth = 1};

}   // namespace

TEST_CASE("the RTL that draws textured instances builds", "[.build]") {
    const TexturedCubes cubes;
    const Scene scene = load_scene(cubes.still(true));
    std::vector<RtlJob> jobs;
    for (const bool is_fast : {false, true}) {
        const Config config = chip(scene, one_bounce, is_fast);
        jobs.push_back({"rc_chip", "textured instances, " + config.name, config});
    }
    REQUIRE_NOTHROW(build_all(jobs));
}

TEST_CASE("textured instances are right under every kind of map, with one level and with two",
          "[textures][levels][map]") {
    const TexturedCubes cubes;
    const bool has_holes = GENERATE(false, true);
    const Scene scene = load_scene(cubes.still(has_holes));
    const TexelFormat texels = GENERATE(TexelFormat::rgb888, TexelFormat::rgb565);
    const Whitted settings{.depth = 1, .aa = has_holes ? 2 : 1};
    std::vector<Trace> traces;
    for (const int levels : {1, 2}) {
        INFO((has_holes ? "with holes, levels " : "levels ") << levels);
        traces.push_back(
            check_picture(scene, {64, 48}, settings, fitted_chip(scene, settings, levels, texels)));
    }
    // Both pictures show the same scene. Their lattices differ, so a few hits and texture levels may differ.
    std::size_t far_apart = 0;
    for (std::size_t i = 0; i < traces[0].colours.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (std::abs(int(traces[0].colours[i][k]) - int(traces[1].colours[i][k])) > 1 << 13) ++far_apart;
    INFO(far_apart << " channels differ by more than an eighth");
    CHECK(far_apart < traces[0].colours.size() / 50);
}

TEST_CASE("surfaces behind a texture are visible through its holes", "[textures][levels]") {
    const TexturedCubes cubes;
    Scene scene = load_scene(cubes.still(true));
    const int levels = GENERATE(1, 2);
    const Config config = fitted_chip(scene, one_bounce, levels, TexelFormat::rgb888);
    const Job job = make_job(scene, *scene.camera, {48, 36}, config, {}, one_bounce);
    const RecordedFrame made = record_frame(job, job.frame);
    // The chip sends a ray through a hole as a bounce, although no material is a mirror.
    CHECK(made.trace.counts.refraction > 20);
    CHECK(made.trace.counts.reflection == 0);
}

TEST_CASE("model and RTL agree on textured instances with holes", "[textures][levels]") {
    const TexturedCubes cubes;
    const Scene scene = load_scene(cubes.still(true));
    const bool is_fast = GENERATE(false, true);
    const Config config = chip(scene, one_bounce, is_fast);
    INFO(config.name);
    const Job job = make_job(scene, *scene.camera, {12, 9}, config, {}, one_bounce);
    check_lockstep(job);
    check_lockstep(job, {15, 40, 7}, 7);
}

TEST_CASE("room is right with short texels", "[textures]") {
    const Scene scene = load_scene("room", {}, Primitives::native);
    const Whitted settings{.depth = 2};
    check_picture(scene, {64, 48}, settings, fitted_chip(scene, settings, 1, TexelFormat::rgb565));
}

}   // namespace rayclock::test::textured_instances_test
