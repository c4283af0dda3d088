// Lockstep over configurations that nobody chose. Every case builds its RTL (about 15 s), hence slow.
#include <catch2/catch.hpp>

#include "model/core/error.hpp"
#include "tests/system/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Legal configuration; every other value from a corner of its range.
Config random_config(std::uint64_t seed) {
    Rng rng(seed);
    const auto draw = [&](const Parameter& p, int most) {
        const int hi = std::min(p.hi, most), pick = rng.below(4);
        int value = pick == 0 ? p.lo : pick == 1 ? hi : p.lo + rng.below(hi - p.lo + 1);
        if (p.power_of_two)
            while (value & (value - 1)) value &= value - 1;
        return value;
    };
    for (;;) {
        Config config;
        config.name = "random " + std::to_string(seed);
        for (const Parameter& p : parameters()) {
            const std::string key = p.key;
            const int most = key == "contexts" ? 128 : key == "mem_latency" ? 60 : key == "mem_interval" ? 4 : key.ends_with("_queue") ? 64 : p.hi;
            config.*p.member = draw(p, most);
        }
        try {
            check_config(config, config.name);
            return config;
        } catch (const UserError&) {
            continue;   // widths that do not go together
        }
    }
}

std::string text_of(const Config& config) {
    std::string text;
    for (const Parameter& p : parameters()) text += std::string(p.key) + "=" + std::to_string(config.*p.member) + " ";
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

} // namespace

TEST_CASE("random configuration", "[slow]") {
    const int seed = GENERATE(range(1, 15));
    check_config_in_lockstep(random_config(std::uint64_t(seed)));
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
