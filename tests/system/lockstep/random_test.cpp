// Lockstep over random configurations with random memory and back-pressure. Every configuration builds its
// own RTL: a few are quick, the others slow.
#include <catch2/catch.hpp>

#include "model/core/parameters.hpp"
#include "model/engine/check.hpp"
#include "sim/explore/torture/random_chip.hpp"
#include "tests/support/machine/build_all.hpp"
#include "tests/support/machine/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

Disturbance random_disturbance(std::uint64_t seed) {
    Rng rng(seed * 77);
    return {rng.below(2) * rng.below(100), rng.below(2) * rng.below(80), rng.next() >> 8};
}

std::string text_of(const Config& config) {
    std::string text;
    for (const Parameter& p : parameters()) text += std::string(p.key) + "=" + value_text(config, p) + " ";
    return text;
}

void check_config_in_lockstep(const Config& config) {
    INFO(text_of(config));
    for (const char* scene : {"teapot:5", config.has_instances() ? "gearbox:1" : "gears:1", "mount:3"}) {
        const Shot shot = make_deep_shot(scene, {32, 24}, config);
        check_lockstep(shot.job);
        check_lockstep(shot.job, {9, 30, 77}, 77);
    }
}

/// Returns a small scene for a list, which tests every primitive for every ray. The picture is also small if
/// few rays are in flight.
Shot random_shot(std::uint64_t seed, const Config& config) {
    const FrameSize size = config.contexts < 16 ? FrameSize{8, 6} : FrameSize{16, 12};
    if (config.is_list()) return make_deep_shot(seed % 2 ? "teapot:1" : "cornell", size, config);
    if (config.has_instances()) return make_deep_shot("gearbox:1", {32, 24}, config);
    return make_deep_shot(seed % 3 == 0   ? "mount:3"
                          : seed % 3 == 1 ? "gears:1"
                                          : "teapot:4",
                          {32, 24}, config);
}

/// Runs every memory with random latency, interval, clock and disturbance.
void check_random(const Config& config, std::uint64_t seed) {
    INFO(text_of(config));
    Rng rng(seed * 1000);
    const Shot shot = random_shot(seed, config);
    std::vector<RecordedFrame> frames;
    for (int i = 0; i < 2; ++i) frames.push_back(record_frame(shot.job, shot.job.frame));
    check_lockstep(shot.job);
    for (int i = 0; i < 6; ++i) {
        Job job = shot.job;
        job.config = with(job.config, {{"dram", (int(config.dram) + i) % int(DramName::board)},
                                       {"mem_latency", 1 + rng.below(60)},
                                       {"mem_interval", 1 + rng.below(4)}});
        job.khz = 20000 + rng.below(500000);
        INFO(job.khz << " kHz");
        check_lockstep(job, frames, random_disturbance(seed * 10 + std::uint64_t(i)), int(seed) * 10 + i);
    }
}

// These quick seeds have one pipeline each.
constexpr std::uint64_t quick_seeds = 2;
Config quick_random(std::uint64_t seed) { return random_chip(seed, true); }

}   // namespace

// Only builds; see lockstep_test.cpp.
TEST_CASE("the RTL of the quick random configurations builds", "[.build]") {
    std::vector<RtlJob> jobs;
    for (std::uint64_t seed = 1; seed <= quick_seeds; ++seed)
        jobs.push_back(
            {"rc_chip", "random " + std::to_string(seed), random_shot(seed, quick_random(seed)).job.config});
    REQUIRE_NOTHROW(build_all(jobs));
}

TEST_CASE("model and RTL agree on a few random configurations, memories and back-pressures") {
    const std::uint64_t seed = GENERATE(range(std::uint64_t(1), quick_seeds + 1));
    check_random(quick_random(seed), seed);
}

TEST_CASE("model and RTL agree on random configurations, memories and back-pressures", "[slow]") {
    const std::uint64_t seed = GENERATE(range(quick_seeds + 1, std::uint64_t(29)));
    check_random(random_chip(seed, false), seed);
}

TEST_CASE("the RTL of random configurations, and of any units that shade, is clean of warnings", "[slow]") {
    const std::uint64_t seed = GENERATE(range(std::uint64_t(1), std::uint64_t(61)));
    // Seeds that are multiples of three shade.
    Config config = random_chip(seed % 4 == 0 ? seed : 3 * seed, false);
    if (config.shading) {   // no scene here needs them
        Rng rng(seed);
        for (bool Config::*unit : {&Config::smooth, &Config::refraction, &Config::supersampling,
                                   &Config::spheres, &Config::planes})
            config.*unit = rng.below(2) != 0;
        if (config.bary_bits + plane_bits + 1 > 32) config.planes = 0;
        config.panes = config.planes && config.refraction ? rng.below(max_panes + 1) : 0;
        config.horizon = config.planes && config.origin_bits >= far_drop && rng.below(2);
    }
    check_config(config, config.name);
    INFO(text_of(config));
    CHECK(lint_rtl(config) == "");
}

TEST_CASE("model and RTL agree for every node width and coordinate width", "[slow]") {
    const int width = GENERATE(2, 4, 8), bits = GENERATE(12, 16, 20);
    check_config_in_lockstep(
        with(named_config("default"),
             {{"node_width", width}, {"coord_bits", bits}, {"stack_depth", 64}, {"contexts", 16}}));
}

TEST_CASE("model and RTL agree with one and two contexts and queues of two", "[slow]") {
    const int contexts = GENERATE(1, 2), queue = GENERATE(2, 4);
    check_config_in_lockstep(with(named_config("default"), {{"contexts", contexts},
                                                            {"raygen_queue", queue},
                                                            {"box_queue", queue},
                                                            {"tri_queue", queue},
                                                            {"stack_depth", 32}}));
}

TEST_CASE("model and RTL agree at both ends of every other width", "[slow]") {
    const std::vector<std::pair<std::string, int>> values = GENERATE(
        std::vector<std::pair<std::string, int>>{{"t_frac_bits", 0}},
        std::vector<std::pair<std::string, int>>{{"t_frac_bits", 8}},
        std::vector<std::pair<std::string, int>>{{"recip_bits", 8}},
        std::vector<std::pair<std::string, int>>{{"recip_bits", 24}},
        std::vector<std::pair<std::string, int>>{{"box_bits", 4}},
        std::vector<std::pair<std::string, int>>{{"bary_bits", 24}},
        std::vector<std::pair<std::string, int>>{{"dir_bits", 12}},
        std::vector<std::pair<std::string, int>>{{"dir_bits", 24}},
        std::vector<std::pair<std::string, int>>{{"coord_bits", 14}, {"dir_bits", 24}, {"recip_bits", 9}});
    check_config_in_lockstep(with(with(named_config("small"), {{"stack_depth", 64}}), values));
}
