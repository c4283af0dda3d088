// rayclock stress: its output and files, its exit codes, and runs that stop and continue.
#include <catch2/catch.hpp>

#include <csignal>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

TEST_CASE("stress reports every test, lattice and family") {
    const ProgramRun run = run_program({"stress", "--bits", "12,20", "--test", "exact,moller", "--family",
                                        "edges,quad,t_junction", "--rays", "60000", "--json", "-"});
    REQUIRE(run.code == 0);
    const json report = json::parse(run.out);
    REQUIRE(report["tests"].size() == 2 * 2 * 3);
    std::uint64_t rays = 0, moller_leaks = 0;
    for (const json& row : report["tests"]) {
        for (const char* key :
             {"rays", "leaks", "double_hits", "oracle_mismatches", "false_shadows", "light_leaks",
              "shadow_rays", "crossings", "walked", "boxes", "boxes_extra", "boxes_lost", "bits"})
            CHECK(row.at(key).is_number_unsigned());
        CHECK((row.at("test").is_string() && row.at("family").is_string()));
        rays += row["rays"].get<std::uint64_t>();
        if (row["test"] == "exact" && row["family"] != "t_junction")
            CHECK(row["leaks"].get<int>() + row["double_hits"].get<int>() +
                      row["oracle_mismatches"].get<int>() ==
                  0);
        if (row["test"] == "moller" && row["family"] == "edges")
            moller_leaks += row["leaks"].get<std::uint64_t>();
    }
    CHECK(moller_leaks > 0);
    CHECK(rays == 66000);   // a tenth for the baseline
    CHECK(report["total"]["rays"] == 66000);
    CHECK(report["good"]["exact"] == true);
    CHECK(report["partial"] == false);
    CHECK(report["host"]["rays_per_core_second"].get<double>() > 0);
}

TEST_CASE("stress prints its verdict and exits with 1 if a demand is not met") {
    const ProgramRun good = run_program(
        {"stress", "--bits", "16", "--test", "exact,inclusive", "--family", "corners", "--rays", "20000"});
    CHECK(good.code == 0);
    CHECK_THAT(good.out,
               Catch::Contains("every decision is the exact one") && Catch::Contains("a control: noticed"));
    // One ray does not find the seam, which says nothing about the test.
    const ProgramRun bad = run_program({"stress", "--bits", "16", "--family", "t_junction", "--rays", "1"});
    CHECK(bad.code == 1);
    CHECK_THAT(bad.out, Catch::Contains("too few rays: the families that must leak do not show it yet") &&
                            !Catch::Contains("WRONG"));
}

TEST_CASE("stress writes a page with a picture of each family") {
    const TestFolder folder;
    const ProgramRun run = run_program(
        {"stress", "--bits", "16", "--family", "fan,ties", "--rays", "2000", "-o", folder.name("page.md")});
    REQUIRE(run.code == 0);
    const auto contents = folder.contents();
    CHECK(contents.count("page.md") == 1);
    CHECK(contents.count("page/fan.svg") == 1);
    CHECK(contents.count("page/ties.svg") == 1);
    CHECK_THAT(contents.at("page.md"), Catch::Contains("](page/fan.svg)") && Catch::Contains("--rays 2000") &&
                                           Catch::Contains("### ties"));
}

TEST_CASE("a stress run that is interrupted keeps what is done and goes on from there", "[long]") {
    const TestFolder folder;
    const std::vector<std::string> arguments{"stress",   "--bits",       "16",
                                             "--family", "edges,shells", "--rays",
                                             "3e6",      "--state",      folder.name("run.json")};
    const ProgramRun stopped = run_and_interrupt(arguments, 1500);
    std::vector<std::string> whole = arguments;
    whole.insert(whole.end(), {"--json", "-"});
    const ProgramRun rest = run_program(whole);
    REQUIRE(rest.code == 0);
    const json report = json::parse(rest.out);
    CHECK(report["total"]["rays"] == 3000000);
    if (stopped.code == 1)
        CHECK_THAT(stopped.out, Catch::Contains("PARTIAL"));
    else
        CHECK(stopped.code == 0);
    // The same without a stop.
    const ProgramRun straight =
        run_program({"stress", "--bits", "16", "--family", "edges,shells", "--rays", "3e6", "--json", "-"});
    CHECK(json::parse(straight.out)["tests"] == report["tests"]);
}
