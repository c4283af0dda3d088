// Successful runs: the printed text, the written files, and every report key that others rely on.
#include <catch2/catch.hpp>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "model/core/parameters.hpp"
#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

/// Checks keys and their types, for example "clocks.0.fps": "number". Dots separate levels.
void check_keys(const json& report, const std::vector<std::pair<std::string, std::string>>& keys) {
    for (const auto& [path, type] : keys) {
        std::string pointer = "/" + path;
        std::replace(pointer.begin(), pointer.end(), '.', '/');
        INFO(path);
        REQUIRE(report.contains(json::json_pointer(pointer)));
        const std::string found = report.at(json::json_pointer(pointer)).type_name();
        if (path.ends_with("psnr_db") && found == "null") continue;   // equal pictures: JSON has no infinity
        CHECK(found == type);
    }
}

void check_shared(const json& report) {
    check_keys(report, {{"scene.name", "string"},
                        {"scene.triangles", "number"},
                        {"scene.spheres", "number"},
                        {"scene.planes", "number"},
                        {"config.name", "string"},
                        {"frame.width", "number"},
                        {"frame.height", "number"},
                        {"work.node_steps", "number"},
                        {"work.box_tests", "number"},
                        {"work.triangle_tests", "number"},
                        {"clocks", "array"},
                        {"digest", "string"},
                        {"host.seconds", "number"}});
    for (const rayclock::Parameter& p : rayclock::parameters()) {
        INFO(p.key);
        CHECK((p.names ? report["config"].at(p.key).is_string()
                       : report["config"].at(p.key).is_number_integer()));
    }
    REQUIRE(!report["clocks"].empty());
    for (const json& clock : report["clocks"]) {
        check_keys(clock, {{"mhz", "number"},
                           {"cycles", "number"},
                           {"fps", "number"},
                           {"mrays_per_s", "number"},
                           {"dram_bytes", "number"},
                           {"dram_gb_per_s", "number"},
                           {"bound", "string"},
                           {"bound_reached", "number"},
                           {"bottleneck", "string"},
                           {"bytes_per_ray", "number"},
                           {"dram_share_of_peak", "number"},
                           {"units", "object"},
                           {"memory", "object"},
                           {"frames", "array"}});
        CHECK(clock["fps"].get<double>() ==
              Approx(clock["mhz"].get<double>() * 1e6 / clock["cycles"].get<double>()));
    }
    REQUIRE(report["units"].size() >= 11);
    for (const auto& [name, unit] : report["units"].items()) {
        INFO(name);
        const auto total = [](const json& parts) {
            std::uint64_t sum = 0;
            for (const auto& [cause, cycles] : parts.items()) sum += cycles.get<std::uint64_t>();
            return sum;
        };
        const std::uint64_t busy = unit.at("busy"), starved = unit.at("starved");
        CHECK(unit.at("count").is_number_unsigned());
        CHECK(total(unit.at("busy_with")) == busy);
        CHECK(total(unit.at("starved_by")) == starved);
        CHECK(busy + starved + total(unit.at("stalled")) ==
              unit.at("instances").get<std::uint64_t>() * report["clocks"][0]["cycles"].get<std::uint64_t>());
    }
}

/// Requires every cause, one cause for each other primitive, and that the oracle judged everything without a
/// fault.
void check_causes(const json& error) {
    std::uint64_t sum = 0;
    for (const char* cause :
         {"snapping", "ray_quantisation", "seam", "t_rounding", "shading", "primitive_test", "bug"}) {
        INFO(cause);
        const std::uint64_t all = error["causes"].at(cause),
                            other = error["causes_other_primitive"].at(cause);
        CHECK(other <= all);
        sum += other;
    }
    CHECK(sum == error["pixels_other_primitive"]);
    CHECK(error["causes"]["bug"] == 0);
    CHECK(error["oracle"]["pixels"] == error["pixels"]);
    CHECK(error["oracle"]["wrong"] == 0);
}

json parsed(const ProgramRun& outcome) {
    INFO(outcome.err);
    CHECK((outcome.err.empty() || (outcome.err.starts_with("rayclock: building ") &&
                                   outcome.err.find('\n') == outcome.err.size() - 1)));
    REQUIRE(json::accept(outcome.out));
    return json::parse(outcome.out);
}

}   // namespace

TEST_CASE("simulate reports every key, on both engines alike") {
    const std::vector<std::string> arguments{"simulate", "teapot:3", "--size", "24x18",
                                             "--clock",  "66,90.5",  "--json", "-"};
    const ProgramRun model = run_program(arguments);
    CHECK(model.code == 0);
    json report = parsed(model);
    check_shared(report);
    check_keys(report, {{"rays.primary", "number"},
                        {"rays.shadow", "number"},
                        {"rays.reflection", "number"},
                        {"rays.refraction", "number"},
                        {"memory.node_cache.accesses", "number"},
                        {"memory.node_cache.hits", "number"},
                        {"memory.prim_cache.accesses", "number"},
                        {"memory.prim_cache.hits", "number"},
                        {"memory.dram.reads", "number"},
                        {"memory.dram.row_hits", "number"},
                        {"memory.dram.name", "string"},
                        {"memory.dram.channels", "number"},
                        {"error.pixels", "number"},
                        {"error.pixels_other_primitive", "number"},
                        {"error.psnr_db", "number"},
                        {"error.max_abs_depth", "number"},
                        {"error.depth_pixels", "number"},
                        {"error.pixels_on_edge", "number"},
                        {"error.oracle.pixels", "number"},
                        {"error.oracle.wrong", "number"},
                        {"host.judge_seconds", "number"},
                        {"host.cycles_per_second", "number"},
                        {"host.rays_per_second", "number"}});
    check_causes(report["error"]);
    CHECK(report["rays"]["primary"] == 24 * 18);
    CHECK(report["clocks"].size() == 2);
    CHECK(report["clocks"][1]["mhz"] == 90.5);

    std::vector<std::string> with_rtl = arguments;
    with_rtl.insert(with_rtl.end(), {"--engine", "rtl"});
    json rtl = parsed(run_program(with_rtl));
    for (json* j : {&report, &rtl}) {
        j->erase("engine");
        j->erase("host");
        (*j)["compile"].erase("seconds");
        (*j)["judge"].erase("seconds");
    }
    CHECK(rtl == report);
}

TEST_CASE("verify reports every key and says so in words") {
    const TestFolder folder;
    const std::string file = folder.name("report.json"), pictures = folder.name("pictures");
    const ProgramRun outcome =
        run_program({"verify", "teapot:3", "--size", "24x18", "--json", file, "-o", pictures});
    INFO(outcome.out << outcome.err);
    CHECK(outcome.code == 0);
    CHECK(outcome.out.find("VERIFIED") != std::string::npos);
    const json report = json::parse(content_of(file));
    check_shared(report);
    check_keys(report, {{"pixels", "number"},
                        {"events_compared", "number"},
                        {"value_mismatches", "number"},
                        {"account_mismatches", "number"},
                        {"cycle_gap", "number"},
                        {"first_divergence", "null"},
                        {"reference.pixels_other_primitive", "number"},
                        {"reference.psnr_db", "number"}});
    check_causes(report["reference"]);
    CHECK(outcome.out.find("judge: 432 camera rays judged") != std::string::npos);
    CHECK(report.contains("golden"));
    CHECK(report["pixels"] == 24 * 18);
    CHECK(report["value_mismatches"] == 0);
    CHECK(report["cycle_gap"] == 0);
    CHECK(report["events_compared"] > 24 * 18 * 4);
    std::vector<std::string> files;
    for (const auto& [name, bytes] : folder.contents()) files.push_back(name);
    CHECK(files == std::vector<std::string>{"pictures", "pictures/difference.png", "pictures/model.png",
                                            "pictures/reference.png", "pictures/rtl.png", "report.json"});
}

TEST_CASE("verify compares with the golden picture where there is one") {
    const ProgramRun outcome = run_program({"verify", "cornell", "--size", "16x12", "--json", "-"});
    CHECK(outcome.code == 0);
    const json report = parsed(outcome);
    check_keys(report, {{"golden.within", "boolean"}});
    CHECK(report["golden"]["within"] == true);
}

TEST_CASE("with --json - JSON is printed and nothing else") {
    const TestFolder folder;
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"scenes"},
             {"doctor"},
             {"render", "tetra:2", "--size", "8x8", "-o", folder.name("x.png")},
             {"simulate", "tetra:2", "--size", "8x8"},
             {"verify", "tetra:2", "--size", "8x8"},
             {"sweep", "tetra:2", "--size", "8x8", "--axis", "contexts=1,2", "--no-netlist"},
             {"bench", "tetra:2", "--size", "8x8"}}) {
        std::vector<std::string> with_json = arguments;
        with_json.insert(with_json.end(), {"--json", "-"});
        INFO(arguments[0]);
        const json report = parsed(run_program(with_json));
        CHECK(!report.empty());
    }
}

TEST_CASE("every command has help with an example") {
    const ProgramRun whole = run_program({"--help"});
    CHECK(whole.code == 0);
    CHECK(whole.err.empty());
    for (const std::string command :
         {"scenes", "config", "render", "simulate", "explain", "trace", "compare", "sweep", "merge", "fit",
          "rtl", "export", "chip", "verify", "stress", "bench", "doctor"}) {
        CHECK(whole.out.find("\n  " + command + " ") != std::string::npos);
        const ProgramRun help = run_program({command, "--help"});
        INFO(help.out);
        CHECK(help.code == 0);
        CHECK(help.err.empty());
        CHECK(help.out.find("Example: rayclock " + command) != std::string::npos);
    }
    CHECK(run_program({"--version"}).code == 0);
}

TEST_CASE("render replaces its output file and writes no other file") {
    const TestFolder folder;
    for (const std::string engine : {"reference", "model", "rtl"})
        for (const std::string ending : {".png", ".exr"}) {
            const std::string file = folder.write(engine + ending, "here before");
            const ProgramRun outcome =
                run_program({"render", "teapot:3", "--size", "24x18", "--engine", engine, "-o", file});
            INFO(outcome.err);
            CHECK(outcome.code == 0);
            CHECK(outcome.err.empty());
            CHECK(content_of(file).substr(0, 4) == (ending == ".png" ? "\x89PNG" : "\x76\x2f\x31\x01"));
        }
    CHECK(folder.contents().size() == 6);
    CHECK(folder.contents()["model.png"] == folder.contents()["rtl.png"]);
}

TEST_CASE("a printed configuration can be given back, and gives the same frame") {
    const TestFolder folder;
    const ProgramRun printed = run_program({"config", "small", "--set", "contexts=8"});
    CHECK(printed.code == 0);
    const std::string file = folder.write("mine.json", printed.out);
    const json a =
        parsed(run_program({"simulate", "tetra:3", "--size", "16x12", "--config", file, "--json", "-"}));
    const json b = parsed(run_program({"simulate", "tetra:3", "--size", "16x12", "--config", "small", "--set",
                                       "contexts=8", "--json", "-"}));
    CHECK(a["digest"] == b["digest"]);
    CHECK(a["config"]["contexts"] == 8);
    const std::string like = folder.write("like.json", R"({"like": "small", "contexts": 8})");
    CHECK(parsed(run_program({"simulate", "tetra:3", "--size", "16x12", "--config", like, "--json",
                              "-"}))["digest"] == a["digest"]);
}

TEST_CASE("the digest does not depend on threads, and a disturbance changes cycles only") {
    const auto run = [](std::vector<std::string> more) {
        std::vector<std::string> arguments{"simulate", "gears:1", "--size", "32x24", "--json", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return parsed(run_program(arguments));
    };
    const json plain = run({}), one = run({"--threads", "1"}),
               slow = run({"--jitter", "30", "--stall", "40", "--seed", "3"});
    CHECK(plain["digest"] == one["digest"]);
    CHECK(plain["error"] == one["error"]);
    CHECK(slow["error"] == plain["error"]);
    CHECK(slow["work"]["triangle_tests"] == plain["work"]["triangle_tests"]);
    CHECK(slow["clocks"][0]["cycles"] > plain["clocks"][0]["cycles"]);
    CHECK(run({"--no-reference"})["error"].is_null());
}
