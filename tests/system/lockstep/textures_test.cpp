// Textures in whole frames: the RTL equals the model in every cycle.
#include <catch2/catch.hpp>

#include "model/compile/surfaces.hpp"
#include "model/engine/check.hpp"
#include "model/machine/machine.hpp"
#include "sim/load/load.hpp"
#include "tests/support/machine/build_all.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::textured_frames_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

const std::vector<std::string> chips{"plain", "two", "fast", "interval"};

/// Returns a chip that draws the scene `room`. `plain` has a pass in every cycle. `two` has short texels, two
/// pipelines, a shared cache, a texture cache with few long lines, and several samples per pixel. `fast` is
/// the chip of the board: fast timing, a pass every eight cycles. `interval` has a pass every four cycles and
/// one miss in flight.
Config textured_chip(const std::string& name) {
    Config c = named_config(name == "fast" ? "ulx3s-shaded" : "default");
    c.name = name;
    c.textures = 1;
    c.contexts = name == "plain" ? 64 : 16;
    if (name == "two") {
        c.texels = TexelFormat::rgb565;
        c.pipelines = 2, c.l2_sets = 64, c.supersampling = 1;
        c.tex_sets = 2, c.tex_ways = 2, c.tex_line = 256;
    }
    if (name == "interval") c.shade_interval = 4, c.tex_mshrs = 1, c.tex_sets = 4, c.tex_ways = 1;
    Whitted most{2};
    most.aa = name == "two" ? 2 : 1;
    c = fitted_config(load_scene("room", {}, Primitives::native), most, c);
    c.stack_depth = 64;
    check_config(c, name);
    return c;
}

Job room(const std::string& chip, int depth) {
    Whitted settings{depth};
    settings.aa = chip == "two" ? 2 : 1;
    const Scene scene = load_scene("room", {}, Primitives::native);
    return make_job(scene, *scene.camera, {20, 15}, textured_chip(chip), {}, settings);
}

void check_room(const std::string& chip) {
    INFO(chip);
    const Job job = room(chip, 2);
    const LockstepResult result = check_lockstep(job);
    CHECK(result.events_compared > 5'000);
    // Memory and sinks that stall.
    check_lockstep(job, {40, 0, 3}, 3);
    check_lockstep(job, {15, 60, 4}, 4);
}

}   // namespace

// Only builds; see lockstep_test.cpp.
TEST_CASE("the RTL of the plain chip with textures builds", "[.build]") {
    REQUIRE_NOTHROW(build_all({{"rc_chip", "textured plain", textured_chip("plain")}}));
}

TEST_CASE("model and RTL agree on a room with textures", "[textures]") { check_room("plain"); }

TEST_CASE("model and RTL of other chips agree on a room with textures", "[textures][long]") {
    check_room(GENERATE(filter([](const std::string& c) { return c != "plain"; }, from_range(chips))));
}

TEST_CASE("model and RTL agree on a room with textures in every memory", "[textures][long]") {
    const std::string chip = GENERATE(from_range(chips));
    INFO(chip);
    for (const char* dram : {"ideal", "sdr_half", "ddr3"}) {
        INFO(dram);
        Job job = room(chip, 1);
        set_parameter(job.config, "dram", dram, "test");
        check_lockstep(job, {10, 20, 5}, 5);
    }
}

TEST_CASE("each textured hit reads one record and one line of texels", "[textures]") {
    for (const std::string& chip : chips) {
        INFO(chip);
        const Job job = room(chip, 2);
        std::vector<RecordedFrame> frames;
        frames.push_back(record_frame(job, job.frame));
        Machine machine(job.config, job.khz, {10, 20, 6});
        prepare_frame(machine, 0, std::span(std::as_const(frames)));
        std::array<std::uint64_t, link_count> moved{};
        machine.start(frames[0].frame, frames[0].trace);
        while (!machine.done()) machine.step([&](const Move& move) { ++moved[index(move.link)]; });
        const auto count = [&](Link link) { return moved[index(link)]; };
        CHECK(count(Link::tex_req) > 100);
        CHECK(count(Link::tex_rsp) == count(Link::tex_req));
        CHECK(count(Link::texel_req) == 2 * count(Link::tex_req));
        CHECK(count(Link::texel_rsp) == 2 * count(Link::tex_req));
        CHECK(count(Link::tex_miss) > 20);
        // A miss reads a line of the cache, word by word.
        const auto words = std::uint64_t(job.config.tex_line / 64);
        CHECK(count(Link::tex_miss) < words * count(Link::texel_req));
        CHECK(count(Link::tex_fill) == count(Link::tex_miss));   // a word each
    }
}

}   // namespace rayclock::test::textured_frames_test
