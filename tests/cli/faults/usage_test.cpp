// Bad usage: exit code 2 and one sentence that names what was wrong.
#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;

namespace {

struct Bad {
    std::vector<std::string> arguments, words;
};

void check(const std::vector<Bad>& cases) {
    for (const Bad& bad : cases) {
        std::string line = "rayclock";
        for (const std::string& word : bad.arguments) line += " '" + word + "'";
        INFO(line);
        check_refused(run_program(bad.arguments), bad.words);
    }
}

/// simulate on a tiny frame, with these further arguments.
Bad simulate(std::vector<std::string> arguments, std::vector<std::string> words) {
    arguments.insert(arguments.begin(), {"simulate", "tetra:1"});
    return {std::move(arguments), std::move(words)};
}

}   // namespace

TEST_CASE("unknown commands and options are refused") {
    check({{{}, {"subcommand"}},
           {{"foo"}, {"'foo'"}},
           {{"simulat", "tetra:1"}, {"'simulat'", "did you mean 'simulate'"}},
           {{"--bogus"}, {"--help"}},
           {{"simulate"}, {"SCENE"}},
           {{"render", "tetra:1"}, {"--output"}},
           simulate({"--bogus"}, {"--bogus"}),
           simulate({"--clok", "66"}, {"'--clok'", "did you mean '--clock'"}),
           simulate({"--clok=66"}, {"'--clok'", "did you mean '--clock'"}),
           {{"sweep", "tetra:1", "--axs", "contexts=1"}, {"'--axs'", "did you mean '--axis'"}},
           {{"--versoin"}, {"'--versoin'", "did you mean '--version'"}},
           simulate({"tetra:2"}, {"tetra:2"}),
           simulate({"-o", "x.png"}, {"-o"}),
           {{"scenes", "extra"}, {"extra"}},
           {{"doctor", "extra"}, {"extra"}},
           {{"config", "default", "small"}, {"small"}}});
}

TEST_CASE("commands that make pages are words of study, and their old names say so") {
    for (const std::string page :
         {"area", "counts", "figures", "gigahertz", "structures", "tradeoff", "yardstick"}) {
        check({{{page}, {page + " is now called 'rayclock study " + page + "'"}},
               {{page, "-o", "never"}, {"'rayclock study " + page + "'"}},
               {{"study", page, "--bogus"}, {"study " + page, "'--bogus'"}}});
        CHECK(run_program({"study", page, "--help"}).out.find("rayclock study " + page) != std::string::npos);
    }
    check({{{"study"}, {"rayclock study --help"}},
           {{"study", "aera"}, {"'aera'", "did you mean 'area'"}},
           {{"study", "simulate"}, {"'simulate'", "rayclock study --help"}}});
}

TEST_CASE("the help fits a screen, in groups") {
    const ProgramRun help = run_program({"--help"});
    CHECK(help.code == 0);
    const std::vector<std::pair<std::string, std::vector<std::string>>> groups{
        {"Run", {"scenes", "config", "render", "simulate", "rays"}},
        {"Look", {"explain", "trace", "compare"}},
        {"Explore", {"sweep", "merge", "fit", "study"}},
        {"Build", {"rtl", "template", "export", "chip", "board"}},
        {"Check", {"verify", "stress", "bench", "doctor"}}};
    std::size_t at = 0;
    for (const auto& [heading, commands] : groups) {
        at = help.out.find("\n" + heading + ":\n", at);
        INFO(heading);
        REQUIRE(at != std::string::npos);
        std::istringstream lines(help.out.substr(at + heading.size() + 3));
        std::vector<std::string> listed;
        for (std::string line; std::getline(lines, line) && line.starts_with("  ");)
            listed.push_back(line.substr(2, line.find(' ', 2) - 2));
        CHECK(listed == commands);
    }
    CHECK(std::count(help.out.begin(), help.out.end(), '\n') <= 48);
    std::istringstream lines(help.out);
    for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
}

TEST_CASE("docs/guide/report.md lists exactly the commands that take --json") {
    const auto words_of = [](const std::vector<std::string>& command) {
        // A line of the help that begins with two blanks and a small letter names a command.
        std::istringstream lines(run_program(command).out);
        std::set<std::string> words;
        for (std::string line; std::getline(lines, line);)
            if (line.size() > 2 && line.starts_with("  ") && std::islower(line[2]))
                words.insert(line.substr(2, line.find(' ', 2) - 2));
        return words;
    };
    std::set<std::string> expected;
    const auto add = [&](std::vector<std::string> command, const std::string& name) {
        command.push_back("--help");
        if (run_program(command).out.find("--json") != std::string::npos) expected.insert(name);
    };
    for (const std::string& name : words_of({"--help"})) add({name}, name);
    for (const std::string& page : words_of({"study", "--help"})) add({"study", page}, "study " + page);
    CHECK(expected.size() > 20);

    const std::string page = content_of(source_folder() + "/docs/guide/report.md");
    const std::size_t begin = page.find("\nThese commands take `--json FILE`: ");
    REQUIRE(begin != std::string::npos);
    const std::size_t first = page.find(": ", begin);
    const std::string list = page.substr(first, page.find("\n\n", first) - first);
    std::set<std::string> told;
    for (std::size_t at = list.find('`'); at != std::string::npos;) {
        const std::size_t end = list.find('`', at + 1);
        told.insert(list.substr(at + 1, end - at - 1));
        at = list.find('`', end + 1);
    }
    CHECK(told == expected);
}

TEST_CASE("an impossible picture size is refused") {
    for (const char* command : {"simulate", "verify", "bench"})
        check({{{command, "tetra:1", "--size", "0x0"}, {"0 x 0", "16384"}}});
    check({{{"render", "tetra:1", "--size", "0x0", "-o", "never.png"}, {"0 x 0", "16384"}},
           simulate({"--size", "100000x100000"}, {"100000 x 100000"}),
           simulate({"--size", "16385x1"}, {"16385 x 1"}),
           simulate({"--size", "1x16385"}, {"1 x 16385"}),
           simulate({"--size", "512"}, {"'512'", "--size"}),
           simulate({"--size", "512x"}, {"'512x'"}),
           simulate({"--size", "x512"}, {"'x512'"}),
           simulate({"--size=-1x5"}, {"-1 x 5"}),
           simulate({"--size", "-1x5"}, {"-1 x 5"}),
           simulate({"--size", "1e3x5"}, {"'1e3x5'"}),
           simulate({"--size", "5x5x5"}, {"'5x5x5'"}),
           simulate({"--size", ""}, {"--size"}),
           simulate({"--size", " 5x5"}, {"' 5x5'"}),
           simulate({"--size", "5x5 "}, {"'5x5 '"}),
           simulate({"--size", "99999999999999999999x1"}, {"99999999999999999999x1"}),
           simulate({"--size", "0x10x10"}, {"0x10x10"})});
}

TEST_CASE("an impossible clock is refused") {
    for (const char* clock : {"0", "-5", "nan", "inf", "-inf", "", "66,,90", "66,", ",66", "abc", "1e9",
                              "0x10", "66 ", "66;90", "-0"})
        check({simulate({std::string("--clock=") + clock}, {"--clock"}),
               {{"verify", "tetra:1", std::string("--clock=") + clock}, {"--clock"}}});
}

TEST_CASE("an illegal parameter is refused with its value") {
    check({simulate({"--set", "coord_bits=11"}, {"coord_bits", "12..20", "11"}),
           simulate({"--set", "coord_bits=21"}, {"coord_bits", "21"}),
           simulate({"--set", "coord_bits=20", "--set", "dir_bits=24"}, {"62", "64"}),
           simulate({"--set", "contexts=3"}, {"power of two", "3"}),
           simulate({"--set", "contexts=0"}, {"contexts", "1..1024"}),
           simulate({"--set", "contexts=-4"}, {"contexts", "-4"}),
           simulate({"--set", "node_width=16"}, {"node_width", "16"}),
           simulate({"--set", "contxts=4"}, {"'contxts'", "did you mean 'contexts'"}),
           simulate({"--set", "contexts"}, {"'contexts'", "key=value"}),
           simulate({"--set", "contexts="}, {"contexts", "whole number"}),
           simulate({"--set", "=4"}, {"--set"}),
           simulate({"--set", "contexts=4.5"}, {"'4.5'"}),
           simulate({"--set", "contexts=1e2"}, {"'1e2'"}),
           simulate({"--set", "contexts=99999999999"}, {"99999999999"}),
           simulate({"--set", ""}, {"--set"}),
           simulate({"--set", "mem_latency=0"}, {"mem_latency"}),
           simulate({"--set", "leaf_size=7"}, {"leaf_size", "7"}),
           {{"rtl", "--set", "coord_bits=21"}, {"coord_bits"}},
           {{"config", "--set", "coord_bits=21"}, {"coord_bits"}},
           {{"simulate", "icosphere:1", "--set", "stack_depth=1"}, {"stack_depth"}}});
}

TEST_CASE("illegal caches, pipelines and memories are refused") {
    check({simulate({"--set", "node_ways=0"}, {"node_ways", "1..8", "0"}),
           simulate({"--set", "prim_sets=0"}, {"prim_sets", "0"}),
           simulate({"--set", "node_sets=48"}, {"node_sets", "power of two", "48"}),
           simulate({"--set", "prim_ways=3"}, {"power of two", "3"}),
           simulate({"--set", "node_line=32"}, {"node_line", "64", "node", "32"}),
           simulate({"--set", "l2_line=0"}, {"l2_line", "64"}),
           simulate({"--set", "prim_line=96"}, {"power of two", "96"}),
           simulate({"--set", "node_mshrs=0"}, {"node_mshrs"}),
           simulate({"--set", "l2_sets=100"}, {"l2_sets", "power of two"}),
           simulate({"--set", "pipelines=3"}, {"pipelines", "power of two"}),
           simulate({"--set", "pipelines=32"}, {"pipelines", "32"}),
           simulate({"--engine", "rtl", "--set", "pipelines=16"}, {"pipelines=16", "model only", "up to 8"}),
           simulate({"--set", "dram_channels=5"}, {"dram_channels", "1..4", "5"}),
           simulate({"--set", "dram=none.json"}, {"none.json", "no such file"}),
           simulate({"--set", "cache_queue=1"}, {"cache_queue"}),
           simulate({"--set", "dram=ddr"}, {"'ddr'", "did you mean 'sdr'"}),
           simulate({"--set", "dram=2"}, {"'2'"}),
           simulate({"--set", "primitive_test=shared"}, {"'shared'", "did you mean 'sheared'"}),
           simulate({"--set", "primitive_test=sheared", "--set", "dir_bits=19"},
                    {"dir_bits", "coord_bits + 2", "20", "19"}),
           simulate({"--engine", "rtl", "--set", "primitive_test=woop"},
                    {"primitive_test=woop", "software only"}),
           {{"verify", "tetra:1", "--set", "primitive_test=moller"},
            {"primitive_test=moller", "software only"}},
           {{"rtl", "--set", "primitive_test=unit24"}, {"primitive_test=unit24", "software only"}},
           simulate({"--set", "tile_bits=9"}, {"tile_bits"}),
           {{"rtl", "--set", "node_ways=0"}, {"node_ways"}},
           {{"simulate", "gears:12", "--set", "dram=rpu", "--set", "coord_bits=20", "--size", "8x8", "--set",
             "node_width=2", "--set", "stack_depth=64"},
            {"'rpu'", "bytes", "dram=ddr3"}}});
}

TEST_CASE("illegal counts of frames and illegal axes are refused") {
    check({simulate({"--frames", "0"}, {"--frames", "0"}),
           simulate({"--frames", "1001"}, {"--frames", "1001"}), simulate({"--frames", "x"}, {"--frames"}),
           simulate({"--pan", "nan"}, {"--pan"}), simulate({"--pan", "361"}, {"--pan", "361"}),
           simulate({"--pan", "x"}, {"--pan"})});
    const auto sweep = [](const std::string& axis, std::vector<std::string> words) {
        return Bad{{"sweep", "tetra:1", "--size", "8x8", "--axis", axis}, std::move(words)};
    };
    check({sweep("contexts", {"'contexts'", "key=values"}),
           sweep("=1,2", {"'=1,2'"}),
           sweep("contexts=", {"contexts="}),
           sweep("contxts=1", {"did you mean 'contexts'"}),
           sweep("contexts=3", {"power of two", "3"}),
           sweep("contexts=1:x", {"'x'"}),
           sweep("contexts=8:4:1", {"8:4:1"}),
           sweep("contexts=1:4:0", {"1:4:0"}),
           sweep("clock=0", {"--clock", "'0'"}),
           sweep("coord_bits=12:2000000000:1", {"10000"}),
           sweep("dram=ideal,ddr", {"'ddr'"}),
           sweep("node_sets/prim_sets=16", {"'16'", "1 values for 2"}),
           sweep("node_sets/prim_sets=16:64", {"no range"}),
           sweep("node_sets/prim_set=16/16", {"did you mean 'prim_sets'"}),
           {{"sweep", "tetra:1"}, {"--axis"}},
           {{"study", "yardstick"}, {"--output"}},
           {{"study", "yardstick", "-o", "no/such/folder/page.md"}, {"no/such/folder/page.md"}}});
}

TEST_CASE("illegal values of other options are refused") {
    check({simulate({"--engine", "gpu"}, {"'gpu'"}),
           simulate({"--engine", "reference"}, {"'reference'"}),
           simulate({"--engine", ""}, {"--engine"}),
           {{"render", "tetra:1", "--engine", "gpu", "-o", "never.png"}, {"'gpu'"}},
           simulate({"--jitter", "-1"}, {"--jitter", "-1"}),
           simulate({"--jitter", "x"}, {"--jitter", "x"}),
           simulate({"--stall", "100"}, {"--stall", "100"}),
           simulate({"--stall", "-1"}, {"--stall"}),
           simulate({"--threads", "-1"}, {"--threads", "-1"}),
           simulate({"--threads", "x"}, {"--threads"}),
           simulate({"--seed", "0"}, {"--seed"}),
           simulate({"--seed", "-1"}, {"--seed"})});
}

TEST_CASE("a scene that does not exist is refused by name") {
    check({{{"simulate", "nosuch"}, {"'nosuch'"}},
           {{"simulate", "tetr:2"}, {"did you mean", "tetra"}},
           {{"simulate", ""}, {"scene"}},
           {{"simulate", "gears:0"}, {"gears", "0"}},
           {{"simulate", "gears:99999999999"}, {"gears", "99999999999"}},
           {{"simulate", "gears:x"}, {"'x'"}},
           {{"simulate", "gears:"}, {"gears"}},
           {{"simulate", "gears:-1"}, {"-1"}},
           {{"verify", "no/such/file.obj"}, {"no/such/file.obj", "no such file"}},
           {{"render", "missing.ply", "-o", "never.png"}, {"missing.ply", "no such file"}}});
}

TEST_CASE("a stress run with illegal options is refused") {
    const auto stress = [](std::vector<std::string> arguments, std::vector<std::string> words) {
        arguments.insert(arguments.begin(), {"stress"});
        return Bad{std::move(arguments), std::move(words)};
    };
    check({stress({"--rays", "0"}, {"--rays", "'0'"}), stress({"--rays", "many"}, {"'many'"}),
           stress({"--rays=-5"}, {"'-5'"}), stress({"--rays", "nan"}, {"'nan'"}),
           stress({"--bits", "11"}, {"--bits", "12..20", "11"}), stress({"--bits", "12:21"}, {"21"}),
           stress({"--bits", "20:12:2"}, {"'20:12:2'"}), stress({"--bits", "12:20:0"}, {"'12:20:0'"}),
           stress({"--bits", "12,12"}, {"--bits", "12", "twice"}), stress({"--bits", ""}, {"--bits"}),
           stress({"--bits", "1:2:3:4"}, {"'1:2:3:4'"}),
           stress({"--test", "exakt"}, {"'exakt'", "did you mean 'exact'"}),
           stress({"--test", "exact,exact"}, {"exact", "twice"}),
           stress({"--family", "edgy"}, {"'edgy'", "did you mean 'edges'"}),
           stress({"--seed", "0"}, {"--seed"}),
           stress({"--state", "/no/such/folder/run.json"}, {"/no/such/folder/run.json"}),
           stress({"-o", "/no/such/folder/page.md"}, {"/no/such/folder/page.md"}),
           stress({"--json", "/no/such/folder/x.json"}, {"/no/such/folder/x.json"}),
           stress({"tetra:1"}, {"tetra:1"})});
}

TEST_CASE("a configuration's name takes precedence over a folder of the same name", "[cli]") {
    const TestFolder folder;
    std::filesystem::create_directory(folder.name("small"));
    const std::string there = "cd '" + folder.name("") + "' && \"$@\"";
    const std::vector<std::string> simulate{"simulate", "tetra:1", "--size",     "8x6",
                                            "--config", "small",   "--no-judge", "--no-reference"};
    REQUIRE(run_in_shell(there, simulate).code == 0);
    std::filesystem::create_directory(folder.name("mine"));
    std::vector<std::string> other = simulate;
    other[5] = "mine";
    const ProgramRun o = run_in_shell(there, other);
    REQUIRE(o.code == 2);
    REQUIRE(o.err.find("mine: is a folder, not a configuration") != std::string::npos);
}

TEST_CASE("a sample has the keys of a simulation, says what is exact, and can be repeated") {
    const auto report = [](std::vector<std::string> words) {
        words.insert(words.begin(),
                     {"simulate", "gears:2", "--size", "333x257", "--clock", "66", "--json", "-"});
        const ProgramRun outcome = run_program(words);
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        return nlohmann::json::parse(outcome.out);
    };
    const nlohmann::json whole = report({}), sample = report({"--sample", "30%", "--seed", "5"}),
                         fast = report({"--within", "0.001s", "--seed", "5"});
    for (const auto& [key, value] : whole.items()) {
        INFO(key);
        CHECK(sample.contains(key));
    }
    CHECK(sample["rays"]["primary"] == 333 * 257);
    CHECK(sample["digest"].is_null());
    CHECK(sample["sampling"]["shortfall"].is_null());
    CHECK(fast["sampling"]["shortfall"].get<std::string>().find("--within 0.001s: the sample took") == 0);
    const double share = 100 * fast["sampling"]["share"].get<double>();
    nlohmann::json again = report({"--sample", std::to_string(share) + "%", "--seed",
                                   std::to_string(fast["sampling"]["seed"].get<int>())});
    CHECK(again["sampling"]["clocks"] == fast["sampling"]["clocks"]);
    // Every tile is dispatched once, also those at the border: 21 x 17.
    const nlohmann::json& tiles = sample["sampling"]["clocks"][0]["figures"]["units.dispatch.busy_with.work"];
    CHECK(tiles["estimate"] == 21 * 17);
    for (const auto& [key, figure] : sample["sampling"]["clocks"][0]["figures"].items()) {
        INFO(key);
        CHECK(figure["half_width"].get<double>() >= 0);
    }
}

TEST_CASE("samples that make no sense are refused") {
    check({simulate({"--sample", "0%"}, {"--sample", "'0%'"}),
           simulate({"--sample", "200%"}, {"--sample", "'200%'"}),
           simulate({"--sample", "60%"}, {"--sample", "'60%'", "30 %"}),
           simulate({"--sample", "2"}, {"--sample", "percentage"}),
           simulate({"--sample", "2%", "--error", "1%"}, {"--sample, --error and --within", "one of them"}),
           simulate({"--error", "1%", "--within", "1s"}, {"--sample, --error and --within", "one of them"}),
           simulate({"--error", "0%"}, {"--error", "'0%'"}),
           simulate({"--within", "3"}, {"--within", "'3'"}),
           simulate({"--within", "0s"}, {"--within", "'0s'"}),
           simulate({"--sample", "2%", "--size", "64x48"}, {"64x48", "65536 pixels"}),
           simulate({"--sample", "2%", "--engine", "rtl"}, {"--engine"}),
           simulate({"--within", "1s", "--frames", "3"}, {"--within", "one frame", "--error"}),
           simulate({"--sample", "2%", "--uploads", "double"}, {"--uploads double", "between"}),
           simulate({"--sample", "2%", "--frames", "0"}, {"--frames"}),
           {{"simulate", "crowd:2", "--sample", "2%", "--frames", "2", "--size", "64x48"}, {"64x48"}},
           {{"stress", "--chips", "9", "--rays", "1000"}, {"--chips"}},
           simulate({"--sample", "2%", "--report", "page.html"}, {"--report"}),
           simulate({"--sample", "2%", "-o", "folder"}, {"--output"}),
           simulate({"--sample", "2%", "--min-psnr", "30"}, {"--min-psnr"}),
           simulate({"--sample", "2%", "--rays", "rays.npy"}, {"--rays"})});
}
