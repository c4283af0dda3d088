// rayclock explain: its figures add up, and its messages name faults in a request.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

json explained(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"explain"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.insert(arguments.end(), {"--json", "-"});
    const ProgramRun outcome = run_program(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(outcome.out);
}

std::uint64_t sum(const json& object) {
    std::uint64_t all = 0;
    for (const auto& [key, value] : object.items()) all += value.get<std::uint64_t>();
    return all;
}

void check_closed(const json& report) {
    const json& cost = report["cost"];
    std::uint64_t cycles = 0, misses = 0;
    for (const json& ray : report["rays"]) {
        std::uint64_t of_ray = 0, visits = 0, tests = 0, missing = 0;
        for (const json& step : ray["steps"]) {
            CHECK(sum(step["units"]) == step["cycles"]);
            CHECK(sum(step["waits"]) + step["work"].get<std::uint64_t>() == step["cycles"]);
            of_ray += step["cycles"].get<std::uint64_t>();
            visits += step["step"] == "visit";
            tests += step["step"] == "test";
            missing += step.value("cache", json()) == "miss" || step.value("cache", json()) == "merge";
        }
        CHECK(of_ray == ray["cycles"]);
        CHECK(visits == ray["node_visits"]);
        CHECK(tests == ray["primitive_tests"]);
        CHECK(missing == ray["cache_misses"]);
        cycles += of_ray, misses += ray["cache_misses"].get<std::uint64_t>();
    }
    CHECK(cycles == cost["cycles"]);
    CHECK(misses == cost["cache_misses"]);
    CHECK(sum(cost["cycles_by_unit"]) == cycles);
    CHECK(sum(cost["cycles_by_cause"]) == cycles);
    CHECK(report["rays"].size() == cost["rays"]);
}

}   // namespace

TEST_CASE("explain reports every ray, visit, test and wait of a pixel, and why its colour differs") {
    const json plain = explained({"gears:2", "20,14", "--size", "40x30"});
    check_closed(plain);
    CHECK(plain["pixel"] == json{20, 14});
    CHECK(plain["colour"]["cause"].is_string());
    CHECK(plain["colour"]["stages"].size() == 6);
    const json finished =
        explained({"spheres", "20,14", "--size", "40x30", "--depth", "3", "--config", "wide"});
    check_closed(finished);
    CHECK(finished["rays"].size() > 5);
    CHECK(finished["rays"][1]["parent"] == 0);
    const json bare = explained({"gears:2", "0,0", "--size", "40x30", "--no-reference", "--frames", "2"});
    check_closed(bare);
    CHECK(bare["colour"].is_null());
}

TEST_CASE("explain counts look-ups that requested a line, and those that found their line in flight") {
    for (const char* pixel : {"12,8", "13,9"}) {
        const json report = explained({"gears:2", pixel, "--size", "40x30", "--no-reference"});
        CAPTURE(pixel);
        check_closed(report);
        const char* outcome = std::string(pixel) == "12,8" ? "miss" : "merge";
        std::uint64_t those = 0;
        for (const json& step : report["rays"][0]["steps"]) those += step.value("cache", json()) == outcome;
        CHECK(those > 1);
        CHECK(those == report["cost"]["cache_misses"]);
    }
}

TEST_CASE("the mean that explain reports is the frame's") {
    const ProgramRun frame = run_program(
        {"simulate", "gears:2", "--size", "40x30", "--clock", "66", "--no-reference", "--json", "-"});
    const json report = json::parse(frame.out);
    const json pixel = explained({"gears:2", "3,4", "--size", "40x30", "--no-reference"});
    CHECK(pixel["cycles"] == report["clocks"][0]["cycles"]);
    CHECK(pixel["cost"]["mean"]["node_visits"].get<double>() ==
          Approx(report["work"]["node_steps"].get<double>() / 1200));
    CHECK(pixel["cost"]["mean"]["bytes"].get<double>() ==
          Approx(report["clocks"][0]["dram_bytes"].get<double>() / 1200));
}

TEST_CASE("explain prints its steps as text") {
    const ProgramRun text = run_program({"explain", "gears:2", "20,14", "--size", "40x30", "--steps"});
    CHECK(text.code == 0);
    for (const char* words : {"pixel (20, 14):", "alone on the chip", "times the mean", "where it was",
                              "what the cycles were for", "ray 0, camera", "boxes met", "why: "}) {
        INFO(words);
        CHECK(text.out.find(words) != std::string::npos);
    }
}

TEST_CASE("explain refuses a pixel outside the picture") {
    check_refused(run_program({"explain", "gears:2", "40,3", "--size", "40x30"}), {"40,3", "0,0 to 39,29"});
    check_refused(run_program({"explain", "gears:2", "-1,3", "--size", "40x30"}), {"-1,3"});
    check_refused(run_program({"explain", "gears:2", "3", "--size", "40x30"}), {"'3'", "255,190"});
    check_refused(run_program({"explain", "gears:2", "3,4", "--clock", "66,90"}), {"--clock", "one clock"});
    check_refused(run_program({"explain", "gears:2"}), {"PIXEL"});
}
