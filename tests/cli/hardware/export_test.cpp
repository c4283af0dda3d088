// An export of `rayclock export` works on its own: its test bench passes under Verilator, and fails if a
// pixel, a counter or a line of memory differs. A folder that cannot be written gives one sentence.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
namespace fs = std::filesystem;
using Catch::Contains;

namespace {

/// Runs an installed program in a folder: `script` in a shell.
ProgramRun in(const std::string& folder, const std::string& script) {
    return run_in_shell("cd '" + folder + "' && " + script, {"--version"});
}

/// Builds the bench as the README of an export describes.
ProgramRun build_bench(const std::string& folder) {
    return in(folder,
              "verilator --binary --timing --x-assign unique --x-initial unique -f chip.f rc_bench.sv "
              "--top-module rc_bench -CFLAGS -O1 > build.log 2>&1");
}

/// Runs the bench and returns its output. Registers start at random values; with a seed above 0 memory and
/// sink are random too.
ProgramRun bench(const std::string& folder, int seed = 0) {
    return in(folder, "obj_dir/Vrc_bench +verilator+rand+reset+2 +verilator+seed+" +
                          std::to_string(seed + 1) + " +seed=" + std::to_string(seed));
}

/// Changes the last digit of the line that holds `mark`. If `mark` is empty, counts from the first line that
/// is not a comment.
void spoil(const std::string& file, std::size_t line) {
    std::string text = content_of(file);
    std::size_t at = 0;
    for (std::size_t i = 0; i < line; ++i) at = text.find('\n', at) + 1;
    const std::size_t digit = text.find_first_of(" \n", at) - 1;
    text[digit] = text[digit] == '0' ? '1' : '0';
    std::ofstream(file, std::ios::binary) << text;
}

std::size_t lines_of(const std::string& text) {
    return std::size_t(std::count(text.begin(), text.end(), '\n'));
}

}   // namespace

TEST_CASE("an export's test bench passes on its own, and sees a pixel, a counter and a memory that is wrong",
          "[long]") {
    const TestFolder folder;
    const std::string place = folder.name("chip");
    const ProgramRun made = run_program(
        {"export", "tetra:2", "--size", "16x12", "--config", "small", "-o", place, "--json", "-"});
    REQUIRE(made.code == 0);
    const auto json = nlohmann::json::parse(made.out);
    for (const auto& name : json["files"]) CHECK(fs::is_regular_file(fs::path(place) / std::string(name)));
    CHECK(lines_of(content_of(place + "/pixels.hex")) == 2 + 16 * 12);
    CHECK(content_of(place + "/memory.bin").size() == 64 * (lines_of(content_of(place + "/memory.hex")) - 1));
    CHECK(folder.contents().count("chip/.rayclock") == 0);

    const ProgramRun built = build_bench(place);
    INFO(content_of(place + "/build.log"));
    REQUIRE(built.code == 0);
    CHECK(content_of(place + "/build.log").find("%Warning") == std::string::npos);
    const ProgramRun good = bench(place);
    CHECK(good.code == 0);
    CHECK_THAT(good.out,
               Contains("PASS: 192 pixels, " + std::to_string(json["cycles"].get<int>()) + " cycles"));
    for (int seed = 1; seed <= 4; ++seed) {
        INFO("seed " << seed);
        const ProgramRun random = bench(place, seed);
        CHECK(random.code == 0);
        CHECK_THAT(random.out, Contains("PASS: 192 pixels, "));
        // Its cycles differ, and each seed has its own.
        CHECK_THAT(random.out, !Contains(", " + std::to_string(json["cycles"].get<int>()) + " cycles"));
        CHECK_THAT(random.out, !Contains(bench(place, seed + 1).out));
    }
    for (const char* file : {"pixels.hex", "counters.hex", "memory.hex"}) {
        INFO(file);
        const std::string path = place + "/" + file, before = content_of(path);
        spoil(path, 2);
        const ProgramRun bad = bench(place);
        CHECK(bad.code != 0);
        CHECK_THAT(bad.out, Contains("FAIL") && !Contains("PASS"));
        // With a seed only pixels are compared. A spoiled memory may change only counters.
        if (file != std::string("memory.hex"))
            CHECK((bench(place, 1).code != 0) == (file == std::string("pixels.hex")));
        std::ofstream(path, std::ios::binary) << before;
    }
    CHECK(bench(place).code == 0);
}

TEST_CASE("an export's test bench sees a register whose reset is missing", "[slow]") {
    const TestFolder folder;
    const std::string place = folder.name("chip");
    REQUIRE(run_program({"export", "tetra:2", "--size", "16x12", "--config", "small", "-o", place}).code ==
            0);
    const std::string path = place + "/rtl/cells/flow/rc_flags.sv", reset = "if (!rst_ni) begin";
    std::string text = content_of(path);
    REQUIRE(text.find(reset) != std::string::npos);
    std::ofstream(path, std::ios::binary)
        << text.replace(text.find(reset), reset.size(), "if (!rst_ni && 1'b0) begin");
    REQUIRE(build_bench(place).code == 0);
    // With registers that start at 0 the fault does not show.
    CHECK_THAT(in(place, "obj_dir/Vrc_bench").out, Contains("PASS: "));
    const ProgramRun seen = bench(place);
    CHECK(seen.code != 0);
    CHECK_THAT(seen.out, Contains("FAIL") && !Contains("PASS"));
}

TEST_CASE("an export's test bench passes under Icarus, where no value that matters is unknown", "[long]") {
    const TestFolder folder;
    if (in(folder.name(""), "command -v iverilog").code != 0) {
        WARN("iverilog is not installed: the export is not tried with it");
        return;
    }
    using Words = std::vector<std::string>;
    for (const Words& what :
         {Words{"tetra:2", "--size", "16x12", "--config", "small"},
          Words{"tetra:2", "--size", "8x6", "--set", "prim_line=128", "--set", "l2_sets=4"},
          Words{"tetra:2", "--size", "8x8", "--config", "ulx3s"},
          Words{"balls:1", "--size", "4x3", "--config", "small", "--depth", "1"}}) {
        const std::string place = folder.name(what[0] + what[2]);
        Words all{"export"};
        all.insert(all.end(), what.begin(), what.end());
        all.insert(all.end(), {"-o", place});
        REQUIRE(run_program(all).code == 0);
        const ProgramRun ran =
            in(place,
               "cat $(grep '\\.sv$' chip.f) rc_bench.sv | sed -f icarus.sed > icarus.sv && "
               "iverilog -g2012 -DSYNTHESIS -s rc_bench -o icarus.vvp icarus.sv "
               ">icarus.log 2>&1 && timeout 120 vvp icarus.vvp");
        INFO(what[0] << ": " << content_of(place + "/icarus.log").substr(0, 500) << ran.out);
        CHECK(ran.code == 0);
        CHECK_THAT(ran.out, Contains("PASS: "));
        if (what[0] == "tetra:2" && what[2] == "16x12")
            CHECK_THAT(in(place, "timeout 120 vvp icarus.vvp +seed=1").out, Contains("PASS: "));
    }
}

TEST_CASE("an export's settings are the frame's, word by word") {
    const TestFolder folder;
    const ProgramRun made = run_program({"export", "balls:1", "--size", "24x16", "--depth", "2", "--config",
                                         "default", "-o", folder.name("chip")});
    REQUIRE(made.code == 0);
    const std::string settings = content_of(folder.name("chip/registers.hex"));
    CHECK_THAT(settings, Contains("0400_00000018   // width\n") && Contains("0401_00000010   // height\n") &&
                             Contains("corner[0], from bit 32\n") && Contains("// lights\n"));
    CHECK_THAT(settings, Catch::EndsWith("0004_00000001   // count cycles\n0003_00000001   // start\n"));
    CHECK_THAT(content_of(folder.name("chip/pixels.hex")), Contains(", colour:51\n"));
    CHECK_THAT(content_of(folder.name("chip/counters.hex")), Contains("shade[0] busy: work\n"));
}

TEST_CASE("a place where no export can be written is one sentence, and nothing is left of it") {
    const TestFolder folder;
    const auto refused = [&](const std::string& place, const std::string& words) {
        INFO(place);
        const auto before = folder.contents();
        check_refused(run_program({"export", "tetra:1", "--size", "8x8", "-o", place}), {words});
        CHECK(folder.contents() == before);
    };
    folder.write("file", "");
    fs::create_directories(folder.name("full"));
    folder.write("full/kept", "");
    fs::create_symlink(folder.name("full"), folder.name("link"));
    refused(folder.name("file"), "is a file, not a folder");
    refused(folder.name("full"), "is not empty");
    refused(folder.name("link"), "is a symbolic link");
    refused(folder.name("none/chip"), "does not exist");
    refused(folder.name("file/chip"), "does not exist");
    refused("", "is empty");
    refused("/proc/chip", "cannot be written");
    // A scene that cannot be made, and a chip without RTL.
    for (const std::vector<std::string>& words : {std::vector<std::string>{"export", "nothing:1"},
                                                  {"export", "tetra:1", "--set", "primitive_test=woop"}}) {
        std::vector<std::string> all = words;
        all.insert(all.end(), {"-o", folder.name("chip")});
        const auto before = folder.contents();
        check_refused(run_program(all), {});
        CHECK(folder.contents() == before);
    }
    // A disk that fills up in the middle of a file.
    const auto before = folder.contents();
    check_refused(run_in_shell("ulimit -f 8; exec \"$@\"",
                               {"export", "tetra:3", "--size", "64x48", "-o", folder.name("chip")}),
                  {"cannot be written"});
    CHECK(folder.contents() == before);
}
