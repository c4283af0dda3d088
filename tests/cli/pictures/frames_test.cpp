// Several frames, several clocks, sweeps, and interrupted runs.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

json report_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "-"});
    const ProgramRun outcome = run_program(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(outcome.out);
}

}   // namespace

TEST_CASE("frames per second are not proportional to the clock, and the accounts say why") {
    const json report =
        report_of({"simulate", "gears:4", "--size", "128x96", "--clock", "33,200", "--no-reference"});
    const json &slow = report["clocks"][0], &fast = report["clocks"][1];
    CHECK(fast["fps"].get<double>() > slow["fps"].get<double>());
    CHECK(fast["fps"].get<double>() / slow["fps"].get<double>() < 0.97 * 200 / 33);
    CHECK(fast["cycles"] > slow["cycles"]);
    CHECK(fast["units"]["box"]["starved_by"]["memory"] > slow["units"]["box"]["starved_by"]["memory"]);
    CHECK(report["units"] == slow["units"]);
    for (const json& clock : report["clocks"]) CHECK(clock["bound_reached"].get<double>() <= 1);
}

TEST_CASE("the second frame finds warm caches, and another view other pixels") {
    const json report = report_of(
        {"simulate", "teapot:6", "--size", "96x72", "--clock", "66", "--frames", "3", "--no-reference"});
    const json& frames = report["clocks"][0]["frames"];
    REQUIRE(frames.size() == 3);
    CHECK(frames[1]["dram_bytes"] < frames[0]["dram_bytes"]);
    CHECK(frames[1]["cycles"] < frames[0]["cycles"]);
    CHECK(report["clocks"][0]["cycles"] == frames[2]["cycles"]);
    const json panned = report_of({"simulate", "teapot:6", "--size", "96x72", "--clock", "66", "--frames",
                                   "3", "--pan", "5", "--no-reference"});
    CHECK(panned["clocks"][0]["frames"][0] == frames[0]);
    CHECK(panned["work"] != report["work"]);
}

TEST_CASE("the RTL makes several frames as the model does") {
    const std::vector<std::string> arguments{"teapot:3", "--size", "24x18", "--clock", "66",
                                             "--frames", "2",      "--pan", "3"};
    std::vector<std::string> verify = arguments;
    verify.insert(verify.begin(), "verify");
    const json checked = report_of(verify);
    CHECK(checked["cycle_gap"] == 0);
    CHECK(checked["value_mismatches"] == 0);
    CHECK(checked["account_mismatches"] == 0);
}

TEST_CASE("a sweep gives the figures of single simulations") {
    const TestFolder folder;
    const std::string table = folder.name("sweep.csv");
    const json report = report_of({"sweep", "tetra:4", "--size", "64x48", "--axis", "node_sets=1,64",
                                   "--axis", "clock=33,200", "--no-netlist", "-o", table});
    REQUIRE(report["points"].size() == 4);
    CHECK(report["partial"] == false);
    for (const json& point : report["points"]) {
        const std::string clock = point["clock"]["mhz"] == 33.0 ? "33" : "200";
        const std::string sets = std::to_string(point["values"]["node_sets"].get<int>());
        const json single = report_of({"simulate", "tetra:4", "--size", "64x48", "--set", "node_sets=" + sets,
                                       "--clock", clock, "--no-reference"});
        CHECK(point["clock"] == single["clocks"][0]);
    }
    const std::string csv = content_of(table);
    CHECK(csv.starts_with("node_sets,clock,cycles,fps,"));
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 5);
}

TEST_CASE("a sweep goes on where a scene does not fit a configuration") {
    const json report =
        report_of({"sweep", "icosphere:2", "--size", "16x12", "--axis", "stack_depth=1,16", "--no-netlist"});
    CHECK(report["points"][0]["refused"].get<std::string>().find("stack_depth") != std::string::npos);
    CHECK(report["points"][1]["clock"]["cycles"] > 0);
}

TEST_CASE("Ctrl-C gives a valid report that is marked as partial") {
    // The model replays while it records. For RTL the rays are recorded first, which takes half a second.
    struct Run {
        const char *engine, *scene, *size, *clock;
        int pixels;
    };
    for (const auto& [engine, scene, size, clock, pixels] :
         {Run{"model", "rings:3", "2048x1536", "66", 2048 * 1536},
          Run{"rtl", "rings:2", "768x576", "66,90", 768 * 576}}) {
        const TestFolder folder;
        const std::string file = folder.name("report.json");
        const ProgramRun outcome = run_and_interrupt({"simulate", scene, "--size", size, "--clock", clock,
                                                      "--engine", engine, "--no-reference", "--json", file},
                                                     2500);
        INFO(engine << ": " << outcome.out << outcome.err);
        REQUIRE(outcome.code == 1);
        CHECK(outcome.out.find("PARTIAL") != std::string::npos);
        const json report = json::parse(content_of(file));
        CHECK(report["partial"] == true);
        CHECK(report["rays"]["primary"] < pixels);
        for (const auto& [name, unit] : report["units"].items()) {
            INFO(name);
            std::uint64_t sum = unit["busy"].get<std::uint64_t>() + unit["starved"].get<std::uint64_t>();
            for (const auto& [cause, cycles] : unit["stalled"].items()) sum += cycles.get<std::uint64_t>();
            CHECK(sum == unit["instances"].get<std::uint64_t>() *
                             report["clocks"][0]["cycles"].get<std::uint64_t>());
        }
        CHECK(folder.contents().size() == 1);
    }
}
