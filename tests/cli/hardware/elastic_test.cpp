// verify --elastic, --unit and template from the command line, and the walk through
// docs/machine/unit-of-your-own.md.
#include <filesystem>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using Catch::Contains;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string page = "docs/machine/unit-of-your-own.md";

/// Returns the texts of the page's blocks in a language.
std::vector<std::string> blocks(const std::string& language) {
    const std::string text = content_of(page), begin = "```" + language + "\n";
    std::vector<std::string> all;
    for (std::size_t at = text.find(begin); at != text.npos; at = text.find(begin, at)) {
        at += begin.size();
        all.push_back(text.substr(at, text.find("```\n", at) - at));
    }
    return all;
}

}   // namespace

TEST_CASE("the steps in docs/machine/unit-of-your-own.md give the results that it states") {
    const TestFolder folder;
    const std::vector<std::string> commands = blocks("sh"), modules = blocks("systemverilog");
    REQUIRE(commands.size() == 3);
    REQUIRE(modules.size() == 1);
    for (const std::string& command : commands) {
        std::istringstream words(command.substr(0, command.find('#')));
        std::vector<std::string> arguments;
        for (std::string word; words >> word;) {
            if (const std::size_t path = word.find("my_tri"); path != word.npos)
                word.replace(path, 6, folder.name("my_tri"));
            arguments.push_back(word);
        }
        REQUIRE(arguments.size() > 2);
        REQUIRE(arguments[0] == "rayclock");
        arguments.erase(arguments.begin());
        const ProgramRun outcome = run_program(arguments);
        INFO(command << outcome.out << outcome.err);
        CHECK(outcome.code == (command.find("exit code 1") == command.npos ? 0 : 1));
        if (arguments[0] == "template") folder.write("my_tri/wrapped_tri.sv", modules[0]);
        if (command.find("--elastic") != command.npos) {
            CHECK_THAT(outcome.out, Contains("VERIFIED") && Contains("times the model's"));
        } else if (arguments[0] == "verify") {
            CHECK_THAT(outcome.out, Contains("FIRST DIVERGENCE") && Contains("unit tri, link tri_req"));
        }
    }
}

TEST_CASE("the wrapper of a template is the unit, in the same cycles") {
    const TestFolder folder;
    REQUIRE(run_program({"template", "box", "--config", "small", "-o", folder.name("box")}).code == 0);
    const std::string readme = content_of(folder.name("box/README.md"));
    CHECK_THAT(readme, Contains("| `box_req` | from node_cache | handshake | ray (") &&
                           Contains("- `box_rsp`: t_near, offset, count in the entries"));
    const ProgramRun outcome =
        run_program({"verify", "--elastic", "box", "--unit", "box=" + folder.name("box/wrapped_box.sv"),
                     "gears:1", "--size", "16x12", "--config", "small", "--json", "-"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const json report = json::parse(outcome.out);
    CHECK(report["value_mismatches"] == 0);
    CHECK(report["cycle_gap"] == 0);
    CHECK(report["counters_compared"] == false);
    CHECK(report["elastic"]["units"] == "box");
    CHECK(report["elastic"]["ratio"] == 1.0);
    CHECK(report["elastic"]["rtl_units"] == report["elastic"]["model_units"]);
    CHECK(report["elastic"]["rtl_cycles"] == report["clocks"][0]["cycles"]);
}

TEST_CASE("a scene may follow --elastic") {
    const ProgramRun outcome = run_program(
        {"verify", "--elastic", "gears:1", "--size", "16x12", "--config", "small", "--json", "-"});
    REQUIRE(outcome.code == 0);
    CHECK(json::parse(outcome.out)["elastic"]["units"] == "all");
}

TEST_CASE("units and files that make no sense are refused in a sentence") {
    const TestFolder folder;
    const std::string empty = folder.write("empty.sv", ""),
                      other = folder.write("other.sv", "module rc_box; endmodule\n"),
                      broken = folder.write("broken.sv", "module rc_tri (input logic clk_i); oops\n");
    const auto verify = [](std::vector<std::string> words) {
        words.insert(words.begin(), {"verify", "gears:1", "--size", "16x12", "--config", "small"});
        return run_program(words);
    };
    check_refused(verify({"--elastic", "tri,bix"}), {"'bix'", "--elastic"});
    check_refused(verify({"--elastic", "shade"}), {"shade", "small"});
    check_refused(verify({"--elastic", ""}), {"--elastic"});
    check_refused(verify({"--unit", "tri"}), {"'tri'", "NAME=FILE"});
    check_refused(verify({"--unit", "=x"}), {"NAME=FILE"});
    check_refused(verify({"--unit", "woop=" + other}), {"woop", "no module"});
    check_refused(verify({"--unit", "tri=" + folder.name("nothing.sv")}), {"nothing.sv", "no such file"});
    check_refused(verify({"--unit", "tri=" + empty}), {"empty.sv", "empty"});
    check_refused(verify({"--unit", "tri=" + other}), {"other.sv", "no module rc_tri"});
    check_refused(verify({"--unit", "box=" + other, "--unit", "box=" + other}), {"twice"});
    const ProgramRun outcome = verify({"--unit", "tri=" + broken});   // a line before says that RTL is built
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, Contains("verilator") && Contains("tri=" + broken) && Contains("failed"));
    check_refused(verify({"--unit-only", "list"}), {"list", "cannot run alone"});
    check_refused(verify({"--unit-only", "woop"}), {"'woop'"});
    check_refused(run_program({"verify", "--torture", "--elastic"}), {"--torture", "--elastic"});
    using Words = std::vector<std::string>;
    for (const Words& odd :
         {Words{"--elastic", "tri"}, Words{"--rays", "rays.npy"}, Words{"--netlist"},
          Words{"--output", "out"}, Words{"--no-wave"}, Words{"--jitter", "10"}, Words{"--stall", "10"}}) {
        Words words{"--unit-only", "tri"};
        words.insert(words.end(), odd.begin(), odd.end());
        check_refused(verify(words), {odd[0], "--unit-only"});
    }
    check_refused(verify({"--unit-only", "tri", "--frames", "2"}), {"several frames", "--unit-only"});
    const std::string out = folder.name("out");
    check_refused(run_program({"template", "bix", "-o", out}), {"'bix'"});
    check_refused(run_program({"template", "memport", "-o", out}), {"memport"});
    check_refused(run_program({"template", "shade", "-o", out}), {"no unit shade"});
    check_refused(run_program({"template", "tri", "-o", folder.name("empty.sv")}), {"empty.sv"});
    CHECK_FALSE(fs::exists(out));
}

TEST_CASE("the run lines of a template have the settings of the chip") {
    const TestFolder folder;
    REQUIRE(run_program(
                {"template", "tri", "--config", "small", "--set", "contexts=16", "-o", folder.name("my_tri")})
                .code == 0);
    CHECK_THAT(content_of(folder.name("my_tri/README.md")),
               Contains("verify gears:2 --size 48x36 --config small --set contexts=16 --elastic tri"));
}

TEST_CASE("a unit alone reports what it compared, and names what it left out") {
    const ProgramRun outcome = run_program(
        {"verify", "gears:1", "--size", "16x12", "--config", "small", "--unit-only", "tri", "--json", "-"});
    REQUIRE(outcome.code == 0);
    const json report = json::parse(outcome.out);
    CHECK(report["events_compared"] > 0);
    CHECK(report["value_mismatches"] == 0);
    for (const char* key : {"pixels", "cycle_gap", "reference", "golden", "judge", "first_divergence"}) {
        INFO(key);
        REQUIRE(report.contains(key));
        CHECK(report[key].is_null());
    }
}

TEST_CASE("the run lines of a template for streams work", "[long]") {
    const TestFolder folder;
    const ProgramRun outcome =
        run_program({"template", "tri", "--config", "small", "--set", "source=stream", "--set", "shading=1",
                     "-o", folder.name("my_tri"), "--json", "-"});
    REQUIRE(outcome.code == 0);
    const json report = json::parse(outcome.out);
    CHECK(report["unit"] == "tri");
    CHECK(report["files"] == json::array({"rc_tri.sv", "wrapped_tri.sv", "README.md"}));
    std::istringstream lines(content_of(folder.name("my_tri/README.md")));
    std::size_t runs = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::vector<std::string> arguments;
        for (std::string word; words >> word;) {
            if (word == "rays.npy") word = folder.name("rays.npy");
            if (const std::size_t file = word.find("=rc_tri.sv"); file != word.npos)
                word = "tri=" + folder.name("my_tri/rc_tri.sv");
            arguments.push_back(word);
        }
        if (arguments.empty() || arguments[0] != "rayclock" || line.find("wrapped") != line.npos) continue;
        if (arguments[1] == "export") continue;
        arguments.erase(arguments.begin());
        const ProgramRun run = run_program(arguments);
        INFO(line << run.out << run.err);
        CHECK(run.code == 0);
        ++runs;
    }
    CHECK(runs == 2);   // the rays and one verification
}

TEST_CASE("sources that the cache cannot track, or that end the program, are refused") {
    const TestFolder folder;
    const auto refused = [&](const std::string& name, const std::string& text) {
        const std::string file = folder.write(name, text);
        const ProgramRun outcome =
            run_program({"verify", "gears:1", "--size", "8x8", "--config", "small", "--elastic", "--unit",
                         name.substr(0, name.find('.')) + "=" + file});
        CHECK(outcome.code == 2);
        return outcome.err;
    };
    CHECK_THAT(refused("tri.sv", "module rc_tri; `include \"part.svh\"\nendmodule\n"),
               Contains("includes another one"));
    CHECK_THAT(refused("tri.sv", "module rc_tri; initial $finish; endmodule\n"), Contains("has $finish"));
    CHECK_THAT(refused("pipeline.sv", "module rc_pipeline; rc_pipeline_own u_own(); endmodule\n"),
               Contains("hides the signals that are compared"));
    for (const std::string list : {"tri,", "memory", ","}) {
        INFO(list);
        CHECK(run_program({"verify", "gears:1", "--size", "8x8", "--config", "small", "--elastic", list})
                  .code == 2);
    }
}
