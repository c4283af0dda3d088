// Builds the RTL that the unit tests load, two modules at a time, before any of them runs.
#include "tests/support/machine/build_all.hpp"
#include "tests/support/dut/cache_dut.hpp"
#include "tests/support/cases/host_cases.hpp"
#include "tests/support/cases/pass_cases.hpp"
#include "tests/support/cases/tex_cases.hpp"
#include <catch2/catch.hpp>

#include "model/engine/check.hpp"

using namespace rayclock;

namespace {

Config tiled(const std::string& bits) {
    Config config = test::format("default");
    config.tile_bits = std::stoi(bits);
    return config;
}
Config pipelines(const std::string& number) {
    Config config = test::format("default");
    config.tile_bits = 3;
    config.pipelines = std::stoi(number);
    return config;
}

}   // namespace

TEST_CASE("the units' RTL is built", "[.build]") {
    struct Job {
        const char *module, *format;
        Config (*config)(const std::string&) = test::format;
    };
    const Job jobs[] = {{"rc_chip", "small"},
                        {"rc_host", "small", test::host_config},
                        {"rc_host", "shaded", test::host_config},
                        {"rc_box", "default"},
                        {"rc_tri", "default"},
                        {"rc_list", "default"},
                        {"rc_trav", "default"},
                        {"rc_box", "wide"},
                        {"rc_tri", "wide"},
                        {"rc_box", "narrow"},
                        {"rc_tri", "narrow"},
                        {"rc_box", "small"},
                        {"rc_tri", "small"},
                        {"rc_raygen", "default"},
                        {"rc_raygen", "wide"},
                        {"rc_raygen", "narrow"},
                        {"rc_raygen", "small"},
                        {"rc_sched", "default"},
                        {"rc_node_cache", "default", test::cache_config},
                        {"rc_prim_cache", "default", test::cache_config},
                        {"rc_node_cache", "smallest", test::cache_config},
                        {"rc_prim_cache", "wide", test::cache_config},
                        {"rc_l2", "direct", test::cache_config},
                        {"rc_unit_vector", "default"},
                        {"rc_power", "default"},
                        {"rc_pass", "all", test::shaded_format},
                        {"rc_pass", "plain", test::shaded_format},
                        {"rc_pass", "narrow", test::shaded_format},
                        {"rc_pass", "levels:mirror", test::shaded_format},
                        {"rc_pass", "every8:fast:levels:all", test::shaded_format},
                        {"rc_shade", "all", test::shaded_format},
                        {"rc_shade", "plain", test::shaded_format},
                        {"rc_shade", "every4:plain", test::shaded_format},
                        {"rc_path_length", "textured:all", test::shaded_format},
                        {"rc_pass", "textured:all", test::shaded_format},
                        {"rc_tex", "rgb888", test::tex_config},
                        {"rc_tex", "rgb565", test::tex_config},
                        {"rc_tex", "narrow", test::tex_config},
                        {"rc_tex", "fine", test::tex_config},
                        {"rc_tex", "levels", test::tex_config},
                        {"rc_log", "rgb888", test::tex_config},
                        {"rc_sched", "0", tiled},
                        {"rc_sched", "3", tiled},
                        {"rc_dispatch", "1", pipelines},
                        {"rc_dispatch", "2", pipelines},
                        {"rc_dispatch", "8", pipelines}};
    std::vector<test::RtlJob> all;
    for (const Job& job : jobs) all.push_back({job.module, job.format, job.config(job.format)});
    test::build_all(all);
    SUCCEED("all are there");
}

TEST_CASE("the RTL of the smallest shapes builds without a warning", "[rtl][slow]") {
    Config config;
    config.leaf_size = 6;
    config.contexts = GENERATE(1, 2);
    config.stack_depth = config.contexts;
    config.node_width = 2 * config.contexts;
    config.raygen_queue = config.box_queue = config.tri_queue = 2;
    config.box_bits = config.bary_bits = 4 * config.contexts;
    check_config(config, "test");
    REQUIRE_NOTHROW(build_rtl(config));
}

TEST_CASE("the RTL of the most contexts builds without a warning", "[rtl][slow]") {
    Config config = test::format("small");
    config.contexts = 1024;
    const char* const module = GENERATE("rc_sched", "rc_trav", "rc_list");
    REQUIRE_NOTHROW(build_rtl(config, module));
}
