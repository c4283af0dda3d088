// A chip with a rounding fault: the program must report a bug, not an error of the lattice.
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

/// Copies rtl/ with `from`, which must occur once, replaced by `to`.
std::string faulty_rtl(const TestFolder& folder, const std::string& file, const std::string& from,
                       const std::string& to) {
    const std::string copy = folder.name("rtl");
    std::filesystem::copy(source_folder() + "/rtl", copy, std::filesystem::copy_options::recursive);
    std::string text = content_of(copy + "/" + file);
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    REQUIRE(text.find(from, at + 1) == std::string::npos);
    std::ofstream(copy + "/" + file, std::ios::binary) << text.replace(at, from.size(), to);
    return copy;
}

}   // namespace

TEST_CASE("a rounding fault in the RTL is a bug, and the exit code says so", "[slow]") {
    const TestFolder folder;
    const std::string rtl = faulty_rtl(folder, "unit/tri/rc_hitdiv.sv", "t_down + {{(TBits-1){1'b0}}, t_up}",
                                       "t_down + {{(TBits-1){1'b0}}, t_up && 1'b0}");
    const std::vector<std::string> environment{"RAYCLOCK_RTL=" + rtl,
                                               "RAYCLOCK_CACHE=" + folder.name("cache")};
    const std::vector<std::string> frame{"teapot:3", "--size", "24x18",  "--config", "small",
                                         "--clock",  "66",     "--json", "-"};

    std::vector<std::string> simulate{"simulate", "--engine", "rtl"};
    simulate.insert(simulate.end(), frame.begin(), frame.end());
    const ProgramRun alone = run_program(simulate, environment);
    CHECK(alone.code == 1);
    const json error = json::parse(alone.out)["error"];
    CHECK(error["oracle"]["wrong"] > 100);
    CHECK(error["causes"]["bug"] == error["oracle"]["wrong"]);
    // The fault does not affect u and v, so the colours are right, and only the oracle detects it.
    CHECK(error["causes_other_primitive"]["bug"] == 0);

    std::vector<std::string> verify{"verify", "--no-wave"};
    verify.insert(verify.end(), frame.begin(), frame.end());
    const ProgramRun verified = run_program(verify, environment);
    CHECK(verified.code == 1);
    CHECK(json::parse(verified.out)["reference"]["causes"]["bug"] == error["causes"]["bug"]);
}
