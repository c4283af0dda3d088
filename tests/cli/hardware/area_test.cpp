// rayclock study area on units that Yosys synthesises in a second: counts, cache hits, refusals.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

const json& part_of(const json& variant, const std::string& name) {
    for (const json& unit : variant["units"])
        if (unit["name"] == name) return unit;
    FAIL("no unit " << name);
    return variant;
}

}   // namespace

TEST_CASE("area counts the units of every machine, each different one once, and finds them again", "[long]") {
    const TestFolder folder;
    const std::vector<std::string> cache{"RAYCLOCK_CACHE=" + folder.name("cache")};
    const auto area = [&](const char* report) {
        return run_program(
            {"study", "area", "--config", "small", "--unit", "sched,dispatch", "--json", folder.name(report)},
            cache);
    };
    const ProgramRun first = area("a.json");
    INFO(first.err);
    REQUIRE(first.code == 0);
    CHECK(first.err.empty());
    CHECK(first.out.find(" of 11 machines, 0 of them known before") != std::string::npos);
    const json report = json::parse(content_of(folder.name("a.json")));
    REQUIRE(report["variants"].size() == 11);
    CHECK(report["variants"][0]["name"] == "hits");
    CHECK(report["variants"][10]["name"] == "all units");
    for (const json& variant : report["variants"]) {
        CHECK(variant["units"].size() == 2);
        const json sched = part_of(variant, "sched")["count"],
                   dispatch = part_of(variant, "dispatch")["count"];
        // The number of the next tile: two counters of the picture's size in tiles, and little else. No
        // multiplier, no memory.
        CHECK(dispatch["ff"].get<int>() >= 16);
        CHECK(dispatch["ff"].get<int>() <= 40);
        CHECK(dispatch["mult18x18d"] == 0);
        CHECK(dispatch["dp16kd"] == 0);
        CHECK(dispatch["dpr16x4"] == 0);
        // The pixel of each context: a memory.
        CHECK(sched["dpr16x4"].get<int>() > 0);
        CHECK(sched["luts"] ==
              sched["lut4"].get<int>() + 2 * sched["ccu2c"].get<int>() + 6 * sched["dpr16x4"].get<int>());
        // Of the two, only sched exists once per pipeline.
        CHECK(variant["pipeline"] == sched);
        if (variant["name"].get<std::string>().starts_with("stream"))
            continue;   // its dispatch counts groups of rays
        CHECK(part_of(variant, "dispatch") == part_of(report["variants"][0], "dispatch"));
    }
    const ProgramRun second = area("b.json");
    REQUIRE(second.code == 0);
    CHECK(content_of(folder.name("b.json")) == content_of(folder.name("a.json")));
    const std::size_t of = second.out.find(" different units");
    REQUIRE(of != std::string::npos);
    CHECK(second.out.find(second.out.substr(0, of) + " of them known before") != std::string::npos);
}

TEST_CASE("area refuses what makes no sense") {
    const TestFolder folder;
    check_refused(run_program({"study", "area", "--unit", "shad"}),
                  {"'shad'", "did you mean 'shade'", "node_cache"});
    check_refused(run_program({"study", "area", "--unit", ""}), {"--unit"});
    check_refused(run_program({"study", "area", "--config", "smal"}), {"'smal'", "small"});
    check_refused(run_program({"study", "area", "--set", "contexts=0"}), {"contexts"});
    check_refused(run_program({"study", "area", "--set", "primitive_test=sheared"}),
                  {"primitive_test=exact"});
    check_refused(run_program({"study", "area", "--unit", "sched", "-o", folder.name("page.md")}),
                  {"--unit", "--output"});
    check_refused(run_program({"study", "area", "-o", folder.name("none/page.md")}), {"none/page.md"});
    check_refused(run_program({"study", "area", "--json", folder.name("none/a.json")}), {"none/a.json"});
    check_refused(run_program({"study", "area", "--threads", "-1"}), {"--threads"});
    check_refused(run_program({"study", "area", "--unit", "sched"},
                              {"PATH=/nonexistent", "RAYCLOCK_CACHE=" + folder.name("cache")}),
                  {"yosys is not installed"});
}
