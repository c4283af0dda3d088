// Parameters of parts that a machine does not have: the program says so, and it is true.
#include <catch2/catch.hpp>

#include "model/base/error.hpp"
#include "model/scene/builtin.hpp"
#include "sim/engine/engine.hpp"
#include "sim/request/idle.hpp"

using namespace rayclock;

namespace {

Config configured(const std::vector<std::pair<std::string, std::string>>& values) {
    Config config = named_config("default");
    for (const auto& [key, value] : values) set_parameter(config, key, value, "test");
    return config;
}

/// A small frame's digest and cycles.
std::pair<std::uint64_t, std::uint64_t> frame_of(const Config& config) {
    static const Scene scene = make_builtin("gears:1", Primitives::triangles);
    const FrameRun run = run_model(make_job(scene, *scene.camera, {16, 12}, config));
    return {run.digest, run.cycles};
}

}   // namespace

TEST_CASE("a setting that is said to have no effect has none") {
    const std::vector<std::vector<std::pair<std::string, std::string>>> machines{
        {{"dram", "ddr3"}}, {{"dram", "ideal"}}, {{"structure", "none"}}};
    for (const auto& values : machines) {
        const Config config = configured(values);
        const auto frame = frame_of(config);
        int idle = 0;
        for (const Parameter& p : parameters()) {
            Config other = config;
            const std::string item = std::string(p.key) + "=";
            if (idle_settings(config, {item}).empty()) continue;
            ++idle;
            other.*p.member = p.power_of_two ? config.*p.member * 2 : config.*p.member + 1;
            if (other.*p.member > p.hi) other.*p.member = p.power_of_two ? config.*p.member / 2 : p.lo;
            INFO(values[0].second << ", " << p.key);
            CHECK_NOTHROW(check_config(other, "test"));
            CHECK(frame_of(other) == frame);
        }
        CHECK(idle > 8);
    }
}

TEST_CASE("a setting without effect is told with what decides it") {
    const Config config = configured({{"dram", "ddr3"}, {"structure", "none"}});
    CHECK(idle_settings(config, {"mem_latency=5"}) ==
          std::vector<std::string>{"mem_latency has no effect with dram=ddr3"});
    CHECK(idle_settings(config, {"l2_ways=2", "contexts=8", "node_sets=4"}) ==
          std::vector<std::string>{"l2_ways has no effect with l2_sets=0",
                                   "node_sets has no effect with structure=none"});
    CHECK(idle_settings(configured({{"dram", "ideal"}}), {"mem_latency=5"}).empty());
}

TEST_CASE("a name that is far from all lists them, if they are few") {
    Config config;
    CHECK_THROWS_WITH(
        set_parameter(config, "dram", "hypermemory", "--set"),
        "--set: no dram is called 'hypermemory'; there are 'ideal', 'sdr', 'ddr3', 'rpu', 'sdr_half'");
    CHECK_THROWS_WITH(named_config("nonsense"),
                      Catch::Contains("is called 'nonsense'; there are 'default', 'small'"));
}
