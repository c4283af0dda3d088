// Streams of rays on the command line.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

namespace rayclock::test::ray_streams_test {

using namespace rayclock::test;
using nlohmann::json;

namespace {

json report(std::vector<std::string> command) {
    command.insert(command.end(), {"--json", "-"});
    const ProgramRun outcome = run_program(command);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(outcome.out);
}

}   // namespace

TEST_CASE("rays are made, traced in lockstep and judged", "[rays]") {
    const TestFolder folder;
    const std::string rays = folder.name("rays.npy"), hits = folder.name("hits.npy");
    for (const std::string kind : {"camera", "shadow", "mirror", "ao", "diffuse"}) {
        INFO(kind);
        const json made = report({"rays", "gears:1", "--kind", kind, "--size", "24x18", "-o", rays});
        const json traced = report({"verify", "gears:1", "--rays", rays, "--hits", hits});
        CHECK(traced["stream"]["rays"] == made["rays"]);
        CHECK(traced["rays"]["primary"].get<int>() + traced["rays"]["shadow"].get<int>() == made["rays"]);
        CHECK((traced["rays"]["shadow"] == 0) == (kind != "shadow" && kind != "ao"));
        CHECK(traced["cycle_gap"] == 0);
        CHECK(traced["value_mismatches"] == 0);
        CHECK(traced["judge"]["wrong"] == 0);
        CHECK(traced["judge"]["rays"] == made["rays"]);
        const std::string bytes = content_of(hits);
        CHECK(bytes.find("('primitive', '<u4')") != std::string::npos);
        CHECK(bytes.size() == 256 + 42 * made["rays"].get<std::size_t>());
        CHECK(report({"simulate", "gears:1", "--rays", rays, "--clock", "66"})["clocks"][0]["cycles"] ==
              traced["clocks"][0]["cycles"]);
    }
    const json elastic = report({"verify", "gears:1", "--rays", rays, "--elastic", "tri"});
    CHECK(elastic["value_mismatches"] == 0);
    CHECK(elastic["events_compared"] > 1000);
    CHECK(elastic["cycle_gap"] == 0);
    CHECK(elastic["elastic"]["rtl_cycles"] == elastic["clocks"][0]["cycles"]);
    CHECK(elastic["judge"]["wrong"] == 0);
}

TEST_CASE("every point of a sweep with a stream has the cycles of simulate", "[rays]") {
    const TestFolder folder;
    const std::vector<std::string> cache{"RAYCLOCK_CACHE=" + folder.name("cache")};
    const std::string rays = folder.name("rays.npy"), csv = folder.name("sweep.csv");
    report({"rays", "gears:1", "--kind", "diffuse", "--size", "24x18", "-o", rays});
    const std::vector<std::string> grid{"sweep",  "gears:1",        "--rays",      rays,
                                        "--axis", "node_sets=1,16", "--axis",      "coord_bits=14,18",
                                        "--axis", "clock=66,200",   "--no-netlist"};
    const auto run = [&](std::vector<std::string> more) {
        more.insert(more.begin(), grid.begin(), grid.end());
        const ProgramRun outcome = run_program(more, cache);
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        return outcome.out;
    };
    const json swept = json::parse(run({"-o", csv, "--json", "-"}));
    CHECK(swept["frame"].is_null());
    CHECK(swept["front"]["error"].is_null());
    CHECK(swept["front"]["speed"] == "mrays_per_s");
    CHECK(swept["sweep"]["stream"]["file"] == rays);
    REQUIRE(swept["points"].size() == 8);
    for (const json& point : swept["points"]) {
        const std::string sets = std::to_string(point["node_sets"].get<int>()),
                          bits = std::to_string(point["coord_bits"].get<int>()),
                          clock = std::to_string(point["values"]["clock"].get<int>());
        INFO(sets << " sets, " << bits << " bits, " << clock << " MHz");
        const json one = report({"simulate", "gears:1", "--rays", rays, "--clock", clock, "--set",
                                 "node_sets=" + sets, "--set", "coord_bits=" + bits});
        for (const char* key : {"cycles", "mrays_per_s", "bytes_per_ray"})
            CHECK(point["clock"][key] == one["clocks"][0][key]);
        CHECK(point["node_hit_rate"] == one["clocks"][0]["frames"][0]["node_hit_rate"]);
        CHECK(point["rays"]["primary"] == swept["sweep"]["stream"]["rays"]);
        CHECK(point["error"].is_null());
        CHECK(point["cracks"].is_null());
    }
    const std::string head = content_of(csv).substr(0, content_of(csv).find('\n'));
    CHECK_THAT(head, Catch::EndsWith(",mrays_per_s,cycles_half_width"));

    // Cached figures serve the same rays, but not the same rays for any hit.
    CHECK(run({}).find("8 points from 2 traces, 8 of them known before") != std::string::npos);
    CHECK(run({"--any-hit"}).find(" 0 of them known before") != std::string::npos);

    // Parts of the sweep, merged, are the sweep.
    const std::string one = folder.name("1.json"), two = folder.name("2.json");
    run({"--shard", "1/2", "--json", one});
    run({"--shard", "2/2", "--json", two});
    const ProgramRun merged = run_program({"merge", two, one, "--json", "-"});
    INFO(merged.err);
    REQUIRE(merged.code == 0);
    CHECK(json::parse(merged.out)["points"] == swept["points"]);
    run({"--any-hit", "--shard", "2/2", "--json", two});
    CHECK(run_program({"merge", two, one}).err.find("differ in the request (stream)") != std::string::npos);
}

TEST_CASE("explain follows a stream's ray until its answer leaves the chip", "[rays]") {
    const TestFolder folder;
    const std::string rays = folder.name("rays.npy"), hits = folder.name("hits.npy"),
                      page = folder.name("ray.html");
    for (const std::string kind : {"diffuse", "ao"}) {
        const std::size_t count =
            report({"rays", "gears:1", "--kind", kind, "--size", "24x18", "-o", rays})["rays"];
        report({"simulate", "gears:1", "--rays", rays, "--clock", "66", "--hits", hits});
        const std::string bytes = content_of(hits);
        for (const std::size_t ray : {std::size_t(0), std::size_t(17), count - 1}) {
            INFO(kind << " ray " << ray);
            const json told = report({"explain", "gears:1", "--rays", rays, "--ray", std::to_string(ray)});
            CHECK(told["ray"] == ray);
            REQUIRE(told["rays"].size() == 1);
            const json& only = told["rays"][0];
            CHECK(only["kind"] == (kind == "ao" ? "any hit" : "closest hit"));
            const char* row = bytes.data() + bytes.size() - 42 * (count - ray);
            std::uint32_t primitive;
            std::uint64_t cycle;
            std::memcpy(&primitive, row + 2, sizeof primitive);
            std::memcpy(&cycle, row + 34, sizeof cycle);
            CHECK(only["first_cycle"].get<std::uint64_t>() + only["cycles"].get<std::uint64_t>() == cycle);
            CHECK(only["hit"].is_null() == (row[0] == 0));
            if (kind == "diffuse" && row[0]) CHECK(only["hit"]["primitive"] == primitive);
            std::uint64_t cycles = 0, visits = 0;
            for (const json& step : only["steps"]) {
                cycles += step["cycles"].get<std::uint64_t>();
                visits += step["step"] == "visit";
            }
            CHECK(cycles == only["cycles"]);
            CHECK(visits == only["node_visits"]);
            CHECK(told["cost"]["cycles"] == cycles);
            CHECK(told["cost"]["cycles_by_unit"].contains("stream"));
        }
    }
    REQUIRE(run_program({"explain", "gears:1", "--rays", rays, "--ray", "3", "--report", page}).code == 0);
    CHECK(content_of(page).find("<title>Ray 3 of gears:1 on default") != std::string::npos);
}

TEST_CASE("render answers a stream with each engine, without timing", "[rays]") {
    const TestFolder folder;
    const std::string rays = folder.name("rays.npy"), hits = folder.name("hits.npy");
    const std::size_t count =
        report({"rays", "gears:1", "--kind", "camera", "--size", "24x18", "-o", rays})["rays"];
    report({"simulate", "gears:1", "--rays", rays, "--hits", hits});
    const auto without_cycles = [&](std::string bytes) {
        for (std::size_t i = 0; i < count; ++i) std::fill_n(bytes.end() - long(42 * i) - 8, 8, '\0');
        return bytes;
    };
    const std::string simulated = without_cycles(content_of(hits));
    CHECK(simulated != content_of(hits));
    for (const std::string engine : {"model", "rtl"}) {
        const json told = report({"render", "gears:1", "--rays", rays, "--engine", engine, "--hits", hits});
        CHECK(content_of(hits) == simulated);
        CHECK(told["stream"]["rays"] == count);
        CHECK(told["stream"]["hits"].get<std::size_t>() > count / 8);
    }
    report({"render", "gears:1", "--rays", rays, "--engine", "reference", "--hits", hits});
    const std::string reference = content_of(hits);
    REQUIRE(reference.size() == simulated.size());
    std::size_t other = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t row = simulated.size() - 42 * (i + 1);
        double t[2];
        std::memcpy(&t[0], simulated.data() + row + 10, 8),
            std::memcpy(&t[1], reference.data() + row + 10, 8);
        const bool same = simulated.compare(row, 6, reference, row, 6) == 0;
        other += !same;
        if (same && simulated[row]) CHECK(std::abs(t[0] / t[1] - 1) < 1e-3);
    }
    CHECK(other <= count / 100);
}

TEST_CASE("the reference's answers to rays for any hit within a radius are those of the model", "[rays]") {
    const TestFolder folder;
    const std::string rays = folder.name("rays.npy"), hits = folder.name("hits.npy");
    report({"rays", "gears:1", "--kind", "ao", "--radius", "1", "--size", "24x18", "-o", rays});
    const auto hit_count = [&](const char* engine) {
        const json told = report({"render", "gears:1", "--rays", rays, "--engine", engine, "--hits", hits});
        return told["stream"]["hits"].get<int>();
    };
    const int model = hit_count("model"), reference = hit_count("reference");
    CHECK(model >= 8);
    CHECK(model == reference);
}

TEST_CASE("stress runs a stream on random chips in lockstep", "[rays][long]") {
    const TestFolder folder;
    const std::string rays = folder.name("rays.npy");
    report({"rays", "tetra:1", "--kind", "camera", "--size", "6x4", "-o", rays});
    const json told = report({"stress", "tetra:1", "--rays", rays, "--chips", "1", "--seed", "4"});
    REQUIRE(told["chips"].size() == 1);
    const json& chip = told["chips"][0];
    CHECK(chip["seed"] == 4);
    CHECK(chip["config"]["source"] == "stream");
    CHECK(chip["events_compared"] > 100);
    CHECK(chip["value_mismatches"] == 0);
    CHECK(chip["cycle_gap"] == 0);
    CHECK(chip["judge"]["rays"] == 24);
    CHECK(chip["judge"]["wrong"] == 0);
    CHECK(told["failed"] == 0);
    CHECK(told["partial"] == false);
}

TEST_CASE("options that a stream cannot use are refused", "[rays]") {
    const TestFolder folder;
    const std::string rays = folder.name("rays.npy");
    REQUIRE(run_program({"rays", "gears:1", "--size", "4x3", "-o", rays}).code == 0);
    const auto refused = [&](std::vector<std::string> more) {
        const ProgramRun outcome = run_program(more);
        CHECK(outcome.code == 2);
        return outcome.err;
    };
    for (const std::vector<std::string>& odd :
         std::vector<std::vector<std::string>>{{"--size", "8x8"},
                                               {"--depth", "2"},
                                               {"--ground"},
                                               {"--material", "gold"},
                                               {"--time", "1"},
                                               {"--min-psnr", "60"},
                                               {"--frames", "2"},
                                               {"--no-reference"},
                                               {"-o", folder.name("out")}}) {
        std::vector<std::string> command{"simulate", "gears:1", "--rays", rays};
        command.insert(command.end(), odd.begin(), odd.end());
        CHECK(refused(command).find("takes the place of a camera") != std::string::npos);
    }
    CHECK(refused({"simulate", "gears:1", "--any-hit"}).find("--any-hit needs --rays") != std::string::npos);
    CHECK(refused({"simulate", "balls:1", "--rays", folder.name("none.npy")}).find("no such file") !=
          std::string::npos);
    CHECK(refused({"simulate", "gears:1", "--rays", rays, "--outside", "keep"}).find("not clip or refuse") !=
          std::string::npos);
    CHECK(refused({"simulate", "gears:1", "--rays", rays, "--set", "smooth=1"})
              .find("smooth=1 needs source=camera") != std::string::npos);
    CHECK(refused({"simulate", "gears:1", "--rays", rays, "--set", "source=camera"})
              .find("needs source=stream") != std::string::npos);
    CHECK(refused({"simulate", "gears:1", "--set", "shading=1", "--set", "source=stream"})
              .find("has no camera") != std::string::npos);
    CHECK(refused({"simulate", "gears:1", "--rays", ""}).find("--rays names no file") != std::string::npos);
    CHECK(refused({"simulate", "gears:1", "--outside", "refuse"}).find("--outside needs --rays") !=
          std::string::npos);
    CHECK(refused(
              {"simulate", "gears:1", "--rays", rays, "--hits", folder.name("a"), "--json", folder.name("a")})
              .find("the same file") != std::string::npos);
    CHECK(refused({"sweep", "gears:1", "--axis", "source=camera,stream"}).find("has no camera") !=
          std::string::npos);
    const auto says = [&](std::vector<std::string> command, const char* part) {
        const std::string said = refused(command);
        INFO(said);
        CHECK(said.find(part) != std::string::npos);
        CHECK(std::count(said.begin(), said.end(), '\n') == 1);
    };
    const std::string axis = "node_sets=8,16";
    says({"sweep", "gears:1", "--rays", rays, "--axis", axis, "--size", "8x8"},
         "so --size has no meaning here");
    says({"sweep", "gears:1", "--rays", rays, "--axis", axis, "--min-psnr", "30"}, "so a limit of errors");
    says({"sweep", "gears:1", "--rays", rays, "--axis", axis, "--report", folder.name("a.html")},
         "a stream of rays has no picture");
    says({"sweep", "gears:1", "--rays", rays, "--axis", axis, "--plot", "psnr_db,cycles"},
         "'psnr_db' is empty, because a stream of rays has no picture");
    says({"sweep", "gears:1", "--any-hit", "--axis", axis}, "--any-hit needs --rays");
    says({"explain", "gears:1", "--rays", rays}, "--rays needs --ray N");
    says({"explain", "gears:1", "--rays", rays, "--ray", "12"}, "whose rays are 0 to 11");
    says({"explain", "gears:1", "--rays", rays, "--ray", "-1"}, "-1 is not a ray of");
    says({"explain", "gears:1", "1,1", "--rays", rays, "--ray", "1"}, "so PIXEL has no meaning here");
    says({"explain", "gears:1", "1,1", "--ray", "1"}, "--ray needs --rays");
    says({"explain", "gears:1"}, "PIXEL is required");
    says({"render", "gears:1", "--rays", rays}, "--rays needs --hits");
    says({"render", "gears:1", "--rays", rays, "--hits", folder.name("h.npy"), "-o", folder.name("a.png")},
         "so --output has no meaning here");
    says({"render", "gears:1", "--rays", rays, "--hits", folder.name("h.npy"), "--compare"},
         "so --compare has no meaning here");
    says({"render", "gears:1", "--rays", rays, "--hits", folder.name("h.npy"), "--engine", "gpu"},
         "is not reference, model or rtl");
    says({"render", "gears:1"}, "--output is required");
    says({"stress", "--rays", rays}, "SCENE is required");
    says({"stress", "gears:1"}, "only with --rays FILE");
    says({"stress", "gears:1", "--rays", rays, "--bits", "14"}, "so --bits has no meaning here");
    says({"stress", "--any-hit"}, "--any-hit needs --rays");
    const ProgramRun idle = run_program({"simulate", "gears:1", "--rays", rays, "--set", "surf_sets=8"});
    CHECK(idle.code == 0);
    CHECK(idle.err.find("surf_sets has no effect with source=stream") != std::string::npos);
    CHECK(run_program({"simulate", "gears:1", "--rays", rays, "--set", "coord_bits=20"}).code == 0);
    CHECK(refused({"rays", "gears:1", "--kind", "light", "-o", rays}).find("is not one of camera") !=
          std::string::npos);
}

}   // namespace rayclock::test::ray_streams_test
