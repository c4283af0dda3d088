// Lockstep over configurations that nobody chose, under memory and back-pressure that nobody chose. Every configuration builds
// its RTL (about 12 s a pipeline): a few are quick, the others slow.
#include <catch2/catch.hpp>

#include <filesystem>

#include "model/core/error.hpp"
#include "sim/rtl/builder.hpp"
#include "tests/system/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// How large a value is drawn, of those that are legal: no larger than a small frame can tell, or Verilator takes gladly.
int most_of(const Parameter& p) {
    const std::string key = p.key;
    const std::pair<const char*, int> most[] = {{"contexts", 128}, {"mem_latency", 60}, {"mem_interval", 4}, {"raygen_queue", 64}, {"box_queue", 64},
                                                {"tri_queue", 64}, {"cache_queue", 64}, {"node_sets", 64}, {"prim_sets", 64}, {"l2_sets", 128},
                                                {"node_mshrs", 16}, {"prim_mshrs", 16}, {"l2_mshrs", 32}, {"primitive_test", 1},
                                                {"shade_queue", 64}, {"surf_sets", 64}, {"surf_mshrs", 16}, {"lights", 16}};
    for (const auto& [name, value] : most)
        if (key == name) return std::min(value, p.hi);
    return p.hi;
}

/// Legal configuration; every other value from a corner of its range. `single`: one that does not shade, on one pipeline. One pipeline, or one time in four two; a shared cache
/// one time in three.
Config random_config(std::uint64_t seed, bool single) {
    Rng rng(seed);
    const auto draw = [&](const Parameter& p, int hi) {
        const int pick = rng.below(4);
        if (!p.power_of_two) return pick == 0 ? p.lo : pick == 1 ? hi : p.lo + rng.below(hi - p.lo + 1);
        const int lo = std::max(p.lo, 1);
        int steps = 0;
        while (lo << (steps + 1) <= hi) ++steps;
        return pick == 0 ? lo : pick == 1 ? lo << steps : lo << rng.below(steps + 1);
    };
    for (;;) {
        Config config;
        config.name = "random " + std::to_string(seed);
        for (const Parameter& p : parameters()) config.*p.member = draw(p, most_of(p));
        // Not below what the scenes need; from a source of their own.
        Rng widths(seed * 31 + 7);
        config.addr_bits = std::max(config.least_addr_bits(), 15 + widths.below(max_addr_bits - 14));
        config.prim_bits = 16 + widths.below(max_prim_bits - 15);
        config.pixel_bits = 7 + widths.below(max_pixel_bits - 6);
        config.pipelines = rng.below(4) == 0 && !single ? 2 : 1;
        if (rng.below(3) != 0) config.l2_sets = 0;
        // Two in three do not shade. The others have what the scenes need at least: spheres, planes and samples are as drawn.
        config.shading = !single && seed % 3 == 0;
        if (config.shading) config.smooth = config.refraction = 1, config.lights = std::max(config.lights, 5), config.bounces = std::max(config.bounces, 5);
        else config.spheres = config.planes = config.smooth = config.refraction = config.supersampling = 0;
        try {
            check_config(config, config.name);
            return config;
        } catch (const UserError&) {
            continue;   // widths that do not go together
        }
    }
}

Traffic random_traffic(std::uint64_t seed) {
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
    for (const char* scene : {"teapot:5", "gears:1", "mount:3"}) {
        const Shot shot = make_deep_shot(scene, {32, 24}, config);
        check_lockstep(shot.job);
        check_lockstep(shot.job, {9, 30, 77}, 77);
    }
}

Shot random_shot(std::uint64_t seed, const Config& config) {
    return make_deep_shot(seed % 3 == 0 ? "mount:3" : seed % 3 == 1 ? "gears:1" : "teapot:4", {32, 24}, config);
}

/// Every memory, and draws of latency, interval, clock and traffic.
void check_random(const Config& config, std::uint64_t seed) {
    INFO(text_of(config));
    Rng rng(seed * 1000);
    const Shot shot = random_shot(seed, config);
    std::vector<FrameTrace> frames;
    for (int i = 0; i < 2; ++i) frames.push_back(record_frame(shot.job, shot.job.frame));
    check_lockstep(shot.job);
    for (int i = 0; i < 6; ++i) {
        Job job = shot.job;
        job.config = with(job.config, {{"dram", (config.dram + i) % int(dram_names().size())}, {"mem_latency", 1 + rng.below(60)}, {"mem_interval", 1 + rng.below(4)}});
        job.khz = 20000 + rng.below(500000);
        INFO(job.khz << " kHz");
        check_lockstep(job, frames, random_traffic(seed * 10 + std::uint64_t(i)), int(seed) * 10 + i);
    }
}

// These seeds are quick: one pipeline each.
constexpr std::uint64_t quick_seeds = 4;
Config quick_random(std::uint64_t seed) { return random_config(seed, true); }

} // namespace

// Not a test of its own; see lockstep_test.cpp.
TEST_CASE("the RTL of the quick random configurations builds", "[.build]") {
    for (std::uint64_t seed = 1; seed <= quick_seeds; ++seed) {
        INFO(seed);
        const Shot shot = random_shot(seed, quick_random(seed));
        CHECK(std::filesystem::exists(build_rtl(shot.job.config).library));
    }
}

TEST_CASE("a few random configurations, memories and back-pressures") {
    const std::uint64_t seed = GENERATE(range(std::uint64_t(1), quick_seeds + 1));
    check_random(quick_random(seed), seed);
}

TEST_CASE("random configurations, memories and back-pressures", "[slow]") {
    const std::uint64_t seed = GENERATE(range(quick_seeds + 1, std::uint64_t(29)));
    check_random(random_config(seed, false), seed);
}

TEST_CASE("every node width with every coordinate width", "[slow]") {
    const int width = GENERATE(2, 4, 8), bits = GENERATE(12, 16, 20);
    check_config_in_lockstep(with(named_config("default"), {{"node_width", width}, {"coord_bits", bits}, {"stack_depth", 64}, {"contexts", 16}}));
}

TEST_CASE("one and two contexts, queues of two", "[slow]") {
    const int contexts = GENERATE(1, 2), queue = GENERATE(2, 4);
    check_config_in_lockstep(with(named_config("default"), {{"contexts", contexts}, {"raygen_queue", queue}, {"box_queue", queue},
                                                            {"tri_queue", queue}, {"stack_depth", 32}}));
}

TEST_CASE("the least and the most of every other width", "[slow]") {
    const std::vector<std::pair<std::string, int>> values = GENERATE(
        std::vector<std::pair<std::string, int>>{{"t_frac_bits", 0}}, std::vector<std::pair<std::string, int>>{{"t_frac_bits", 8}},
        std::vector<std::pair<std::string, int>>{{"recip_bits", 8}}, std::vector<std::pair<std::string, int>>{{"recip_bits", 24}},
        std::vector<std::pair<std::string, int>>{{"box_bits", 4}}, std::vector<std::pair<std::string, int>>{{"bary_bits", 24}},
        std::vector<std::pair<std::string, int>>{{"dir_bits", 12}}, std::vector<std::pair<std::string, int>>{{"dir_bits", 24}},
        std::vector<std::pair<std::string, int>>{{"coord_bits", 14}, {"dir_bits", 24}, {"recip_bits", 9}});
    check_config_in_lockstep(with(with(named_config("small"), {{"stack_depth", 64}}), values));
}
