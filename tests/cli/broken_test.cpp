// Hardware that is wrong: verify ends with 1 and names the first divergence.
#include <catch2/catch.hpp>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
namespace fs = std::filesystem;

namespace {

/// A copy of the project's RTL in `folder` with one text replaced; it must be there exactly once.
std::string broken_rtl(const Folder& folder, const std::string& file, const std::string& old,
                       const std::string& fresh) {
    const std::string copy = folder.name("rtl");
    fs::copy(RAYCLOCK_SOURCE_DIR "/rtl", copy, fs::copy_options::recursive);
    std::string text = bytes_of(copy + "/" + file);
    const std::size_t at = text.find(old);
    REQUIRE(at != std::string::npos);
    REQUIRE(text.find(old, at + 1) == std::string::npos);
    folder.write("rtl/" + file, text.replace(at, old.size(), fresh));
    return copy;
}

}   // namespace

TEST_CASE("verify names the first divergence of wrong RTL: a value") {
    const Folder folder;
    // u of every hit is one too large.
    const std::string rtl =
        broken_rtl(folder, "isect/rc_hitdiv.sv", "assign u_o = {", "assign u_o = (B+1)'(1) + {");
    const std::vector<std::string> environment{"RAYCLOCK_RTL=" + rtl,
                                               "RAYCLOCK_CACHE=" + folder.name("cache")};
    const std::string file = folder.name("report.json");
    const Outcome outcome =
        run_program({"verify", "tetra:3", "--size", "24x18", "--json", file}, environment);
    INFO(outcome.out << outcome.err);
    CHECK(outcome.code == 1);
    CHECK(outcome.err ==
          "rayclock: building the RTL of 'default', once for all runs; this may take a minute\n");
    CHECK(outcome.out.find("FIRST DIVERGENCE at cycle ") != std::string::npos);
    CHECK(outcome.out.find("unit tri, link tri_rsp") != std::string::npos);
    CHECK(outcome.out.find("FAILED") != std::string::npos);
    CHECK(outcome.out.find("VERIFIED") == std::string::npos);
    const nlohmann::json report = nlohmann::json::parse(bytes_of(file)), d = report["first_divergence"];
    REQUIRE(d.is_object());
    CHECK(report["value_mismatches"] > 0);
    CHECK(report["cycle_gap"] == 0);
    CHECK(d["cycle"].is_number_unsigned());
    CHECK(d["unit"] == "tri");
    CHECK(d["channel"] == "tri_rsp");
    CHECK(d["ray"].is_number_unsigned());
    REQUIRE(d["pixel"].size() == 2);
    CHECK(d["pixel"][0] < 24);
    CHECK(d["pixel"][1] < 18);
    const std::string expected = d["expected"], got = d["got"];
    REQUIRE(expected.starts_with("u="));
    REQUIRE(got.starts_with("u="));
    CHECK(std::stol(got.substr(2)) == std::stol(expected.substr(2)) + 1);
    CHECK(d.contains("wave"));

    // The frame of the wrong RTL is what render shows; it does not stop.
    CHECK(run_program({"render", "tetra:3", "--size", "24x18", "--engine", "rtl", "-o", folder.name("x.png")},
                      environment)
              .code == 0);
}

TEST_CASE("RTL that cannot be built is an error, and leaves nothing in the cache") {
    const Folder folder;
    const std::string rtl = broken_rtl(folder, "bvh/rc_rank.sv", "endmodule", "endmodul");
    fs::create_directory(folder.name("cache"));
    const Outcome outcome = run_program({"verify", "tetra:1", "--size", "8x8"},
                                        {"RAYCLOCK_RTL=" + rtl, "RAYCLOCK_CACHE=" + folder.name("cache")});
    CHECK(outcome.code == 1);
    CHECK(outcome.err.find("rc_rank.sv") != std::string::npos);
    for (const auto& [name, bytes] : folder.contents())
        if (name.starts_with("cache/")) CHECK(name.ends_with(".lock"));
}
