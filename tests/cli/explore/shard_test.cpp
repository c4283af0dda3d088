// A sweep in parts: after merging it equals the sweep of one machine, byte for byte.
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "tests/cli/view/browser.hpp"
#include "tests/cli/under_test.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

using Words = std::vector<std::string>;

Words together(Words a, const Words& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// A small sweep: linked parameters, a clock, refused points, and words.
const Words grid{"sweep",       "tetra:2",        "--size", "16x12",
                 "--axis",      "clock=33,66.5",  "--axis", "coord_bits=18,20",
                 "--axis",      "dir_bits=20,24", "--axis", "node_sets/dram=16/ddr3,64/ideal",
                 "--no-netlist"};

/// A working folder with a cache that all parts share.
struct SharedFolder {
    const TestFolder folder;
    const Words cache{"RAYCLOCK_CACHE=" + folder.name("cache")};

    std::string part(int k) const { return folder.name("part-" + std::to_string(k) + ".json"); }
    ProgramRun run(const Words& words) const { return run_program(words, cache); }
    /// Computes part k of n, and writes its report.
    void work_out(int k, int n) const {
        const ProgramRun o =
            run(together(grid, {"--shard", std::to_string(k) + "/" + std::to_string(n), "--json", part(k)}));
        INFO(o.err);
        REQUIRE(o.code == 0);
    }
    /// Returns part k with one key of the report changed.
    std::string changed(int k, const std::string& pointer, const json& value) const {
        auto report = nlohmann::ordered_json::parse(content_of(part(k)));
        report[nlohmann::ordered_json::json_pointer(pointer)] = value;
        return folder.write("changed.json", report.dump());
    }
};

}   // namespace

TEST_CASE("the parts of a sweep, merged in any order, are the sweep of one machine to the byte") {
    const SharedFolder p;
    const auto written = [&](const std::string& name) {
        return Words{"-o",     p.folder.name(name + ".csv"), "--json", p.folder.name(name + ".json"),
                     "--plot", p.folder.name(name)};
    };
    REQUIRE(p.run(together(grid, written("whole"))).code == 0);
    for (const int parts : {2, 5, 16}) {
        Words merge{"merge"};
        for (int k = parts; k > 0; --k) {
            p.work_out(k, parts);
            merge.push_back(p.part(k));
        }
        const ProgramRun o = p.run(together(merge, written("merged")));
        INFO(o.err);
        REQUIRE(o.code == 0);
        for (const char* kind : {".csv", ".json", ".svg"})
            CHECK(content_of(p.folder.name(std::string("merged") + kind)) ==
                  content_of(p.folder.name(std::string("whole") + kind)));
    }
}

TEST_CASE("each point of a sweep is in one of its parts, and merge prints their number") {
    const SharedFolder p;
    std::size_t points = 0;
    for (const int k : {1, 2, 3}) {
        p.work_out(k, 3);
        points += json::parse(content_of(p.part(k)))["points"].size();
    }
    CHECK(points == 16);
    const ProgramRun o = p.run({"merge", p.part(3), p.part(1), p.part(2)});
    INFO(o.err);
    REQUIRE(o.code == 0);
    CHECK(o.out.find("16 points from 3 files") != o.out.npos);
}

TEST_CASE("merge accepts a complete sweep and changes no byte of its report") {
    const SharedFolder p;
    REQUIRE(p.run(together(grid, {"--json", p.folder.name("whole.json")})).code == 0);
    const ProgramRun again = p.run({"merge", p.folder.name("whole.json"), "--json", "-"});
    CHECK(again.out == content_of(p.folder.name("whole.json")));
}

TEST_CASE("a point of a sweep has its values as numbers, an entry for each parameter, and its hit rates") {
    const SharedFolder p;
    REQUIRE(p.run(together(grid, {"--json", p.folder.name("whole.json")})).code == 0);
    const json whole = json::parse(content_of(p.folder.name("whole.json")));
    REQUIRE(whole["points"].size() == 16);
    CHECK(whole["shard"].is_null());
    const json& point = whole["points"][9];
    CHECK(point["values"] == json::parse(
                                 R"({"clock": 66.5, "coord_bits": 18, "dir_bits": 20,
                                     "node_sets/dram": "64/ideal", "node_sets": 64, "dram": "ideal"})"));
    CHECK(point["coord_bits"] == 18);
    CHECK(point["node_hit_rate"] == point["clock"]["frames"][0]["node_hit_rate"]);
    CHECK(whole["points"][6].contains("refused"));
}

TEST_CASE("files that are not all parts of one sweep are refused by name") {
    const SharedFolder p;
    for (const int k : {1, 2, 3}) p.work_out(k, 3);
    const std::string one = p.part(1), two = p.part(2), three = p.part(3);
    const auto refused = [&](const Words& files, const Words& words) {
        check_refused(p.run(together({"merge"}, files)), words);
    };
    refused({one}, {"2 of 3 parts are missing: 2/3, 3/3"});
    refused({three, one, one}, {one, "both part 1/3"});
    refused({one, two, p.folder.name("none.json")}, {"none.json", "no such file"});
    refused({one, two, p.folder.write("bad.json", "{\"scene\": ")}, {"bad.json"});
    refused({one, two, p.folder.write("other.json", "{}")},
            {"other.json", "not a report of sweep", "'scene'"});
    refused({two, three, p.changed(1, "/partial", true)}, {"changed.json", "interrupted", "continues"});
    refused({two, three, p.changed(1, "/shard/of", 4)},
            {"changed.json", "do not belong to one sweep", "how many parts"});
    refused({two, three, p.changed(1, "/shard/part", 4)}, {"changed.json", "no part 4/3"});
    refused({two, three, p.changed(1, "/shard/part", "x")}, {"changed.json", "shard.part", "a whole number"});
    refused({two, three, p.changed(1, "/shard/program", "x")},
            {"changed.json", "the program that made them"});
    refused({two, three, p.changed(1, "/shard/scene_digest", "x")}, {"changed.json", "the scene's content"});
    refused({two, three, p.changed(1, "/config/contexts", 8)}, {"changed.json", "differ in config"});
    refused({two, three, p.changed(1, "/sweep/axes/0/values/0", "44")}, {"the request (axes)"});
    refused({two, three, p.changed(1, "/shard/points/0", 5)}, {"changed.json", "other points"});
    refused({two, three, p.changed(1, "/points/0/values/clock", "<b>")}, {"changed.json", "another grid"});
    refused({two, three, p.changed(1, "/points/0", 3)}, {"changed.json", "not all of its figures"});
    refused({two, three, p.changed(1, "/points/0/clock/frames", 3)},
            {"changed.json", "not all of its figures"});
    refused({two, three, p.changed(1, "/points", json::array())},
            {"changed.json", "another number of points"});
}

TEST_CASE("a part that a sweep does not have is refused, and so is a part without a report") {
    const SharedFolder p;
    for (const auto& [text, why] :
         std::map<std::string, std::string>{{"3/2", "no part 3 of 2"},
                                            {"0/2", "no part 0 of 2"},
                                            {"1/0", "no part 1 of 0"},
                                            {"1", "not PART/PARTS"},
                                            {"1/2/3", "not PART/PARTS"},
                                            {"a/b", "not PART/PARTS"},
                                            {"1/17", "16 points cannot be 17 parts"}})
        check_refused(p.run(together(grid, {"--shard", text, "--json", p.folder.name("x.json")})),
                      {"--shard", why});
    check_refused(p.run(together(grid, {"--shard", "1/2"})), {"--shard needs --json"});
}

TEST_CASE("an interrupted part continues where it stopped, and cannot be merged before it ends") {
    const SharedFolder p;
    const Words long_grid{"sweep",        "rings:1",   "--size", "128x96", "--axis", "coord_bits=12:20",
                          "--no-netlist", "--threads", "1"};
    const auto part = [&](int k) {
        return together(long_grid, {"--shard", std::to_string(k) + "/2", "--json", p.part(k)});
    };
    const auto kept = [&] {
        std::error_code error;
        return std::distance(std::filesystem::directory_iterator(p.folder.name("cache/sweep"), error),
                             std::filesystem::directory_iterator());
    };
    const ProgramRun stopped = run_and_stop(part(1), p.cache, 2, [&] { return kept() >= 3; });
    CHECK(stopped.code == 1);
    REQUIRE(p.run(part(2)).code == 0);
    check_refused(p.run({"merge", p.part(1), p.part(2)}), {"part-1.json", "interrupted"});
    const ProgramRun again = p.run(part(1));
    REQUIRE(again.code == 0);
    CHECK(again.out.find(" 0 of them known before") == again.out.npos);
    REQUIRE(p.run({"merge", p.part(1), p.part(2), "--json", p.folder.name("merged.json")}).code == 0);
    REQUIRE(run_program(together(long_grid, {"--json", p.folder.name("whole.json")}),
                        {"RAYCLOCK_CACHE=" + p.folder.name("other")})
                .code == 0);
    CHECK(content_of(p.folder.name("merged.json")) == content_of(p.folder.name("whole.json")));
}

namespace {

/// Returns the grid for the script: all words except `sweep`.
std::string grid_words() {
    std::string words;
    for (std::size_t i = 1; i < grid.size(); ++i) words += " '" + grid[i] + "'";
    return words;
}
/// Runs `script` with rayclock in its PATH, in the folder.
void run_script(const SharedFolder& p, const std::string& script) {
    const std::string program = program_under_test();
    const ProgramRun o =
        run_in_shell("cd '" + p.folder.name("") + "' && PATH='" + program.substr(0, program.rfind('/')) +
                         "':$PATH && export PATH '" + p.cache[0] + "' && " + script,
                     {});
    INFO(o.out << o.err);
    REQUIRE(o.code == 0);
}
void check_merged(const SharedFolder& p, int parts) {
    Words merge{"merge", "--json", p.folder.name("merged.json")};
    for (int k = 1; k <= parts; ++k) merge.push_back(p.part(k));
    const ProgramRun merged = p.run(merge);
    INFO(merged.err);
    REQUIRE(merged.code == 0);
    REQUIRE(p.run(together(grid, {"--json", p.folder.name("whole.json")})).code == 0);
    CHECK(content_of(p.folder.name("merged.json")) == content_of(p.folder.name("whole.json")));
}
const std::string sbatch_file = source_folder() + "/docs/examples/sweep.sbatch";

}   // namespace

TEST_CASE("the script of the Slurm array works out its part") {
    const SharedFolder p;
    for (const char* task : {"1", "2", "3"})
        run_script(
            p, "SLURM_ARRAY_TASK_ID=" + std::string(task) + " bash '" + sbatch_file + "' 3" + grid_words());
    check_merged(p, 3);
}

TEST_CASE("GNU parallel works out all parts") {
    if (!is_installed("parallel")) {
        WARN("GNU parallel is not installed");
        return;
    }
    const SharedFolder p;
    run_script(p, "parallel --will-cite -j 2 rayclock sweep" + grid_words() +
                      " --shard {}/3 --json part-{}.json ::: 1 2 3 2>&1");
    check_merged(p, 3);
}

TEST_CASE("Slurm runs the array on a node of its own", "[slow]") {
    for (const char* program : {"munged", "slurmctld", "slurmd", "sbatch"})
        if (!is_installed(program)) {
            WARN(program << " is not installed");
            return;
        }
    const SharedFolder p;
    run_script(p, "bash '" + source_folder() + "/tests/setup/slurm.sh' sbatch --wait --array=1-3 '" +
                      sbatch_file + "' 3" + grid_words());
    check_merged(p, 3);
}
