// Faulty hardware: verify ends with 1 and names the first divergence.
#include <catch2/catch.hpp>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/program.hpp"
#include "tests/cli/view/waveform.hpp"

using namespace rayclock::test;
namespace fs = std::filesystem;

namespace {

/// Copies the project's RTL to `folder` with one text replaced, which must occur exactly once.
std::string broken_rtl(const TestFolder& folder, const std::string& file, const std::string& old,
                       const std::string& fresh) {
    const std::string copy = folder.name("rtl");
    fs::copy(source_folder() + "/rtl", copy, fs::copy_options::recursive);
    std::string text = content_of(copy + "/" + file);
    const std::size_t at = text.find(old);
    REQUIRE(at != std::string::npos);
    REQUIRE(text.find(old, at + 1) == std::string::npos);
    folder.write("rtl/" + file, text.replace(at, old.size(), fresh));
    return copy;
}

/// Checks that every signal of GTKWave's save file exists.
void check_view(const std::string& folder, const Waveform& wave) {
    std::istringstream view(content_of(folder + "/divergence.gtkw"));
    std::size_t shown = 0;
    for (std::string line; std::getline(view, line);) {
        if (!line.starts_with("links.") && !line.starts_with("TOP.")) continue;
        ++shown;
        CHECK(wave.names().count(line) == 1);
    }
    CHECK(shown > 50);
}

/// Checks waveform, save file and page of a divergence of u on the link tri_rsp.
void check_waveform(const TestFolder& folder, const nlohmann::json& d) {
    const std::string out = folder.name("out") + "/";
    REQUIRE(d["wave"] == out + "divergence.fst");
    const Waveform wave(d["wave"]);
    const std::uint64_t cycle = d["cycle"], time = 10 * cycle;
    const auto number = [&](const std::string& name, std::uint64_t at) {
        return std::stol(wave.at(name, at), nullptr, 2);
    };
    const std::string link = "links.tri_rsp.";
    CHECK(number(wave.name_with("links.cycle"), time) == long(cycle));
    // It is the first cycle in which the link differs, with the reported difference.
    CHECK(wave.at(link + "differs", time) == "1");
    for (std::uint64_t c = cycle > 1000 ? cycle - 1000 : 0; c < cycle; ++c)
        REQUIRE(wave.at(link + "differs", 10 * c) == "0");
    const auto u = [&](const char* side) {
        return "u=" + std::to_string(number(wave.name_with(link + "u_" + side), time));
    };
    CHECK(u("model") == d["expected"].get<std::string>());
    CHECK(u("rtl") == d["got"].get<std::string>());
    CHECK(wave.first() == (cycle > 1000 ? 10 * (cycle - 1000) : 0));
    CHECK(wave.last() > time);
    // The clock rises when a cycle begins, and the link shows the RTL's own offer at that time.
    CHECK(wave.at("TOP.clk_i", time) == "1");
    CHECK(wave.at("TOP.clk_i", time + 5) == "0");
    const std::string offered = wave.name_with(".u_tri.rsp_valid_o");
    REQUIRE(!offered.empty());
    CHECK(wave.at(offered, time + 5) == "1");

    check_view(folder.name("out"), wave);
    const std::string page = content_of(out + "divergence.html");
    for (const std::string& part :
         {std::string("with another payload"), std::string("rtl/unit/tri/rc_tri.sv:"),
          std::string("assign rsp_o = "), std::string(d["expected"]), std::string(d["got"]),
          std::string("prim_req from list to prim_cache"), std::string("<th>rsp_valid_o</th>")})
        CHECK(page.find(part) != std::string::npos);
}

}   // namespace

TEST_CASE("verify names the first divergence of wrong RTL, and shows it as a waveform", "[long]") {
    const TestFolder folder;
    // u of every hit is one too large.
    const std::string rtl =
        broken_rtl(folder, "unit/tri/rc_hitdiv.sv", "assign u_o = {", "assign u_o = (BaryBits+1)'(1) + {");
    const std::vector<std::string> environment{"RAYCLOCK_RTL=" + rtl,
                                               "RAYCLOCK_CACHE=" + folder.name("cache")};
    const std::string file = folder.name("report.json");
    const ProgramRun outcome = run_program({"verify", "tetra:3", "--size", "24x18", "--config", "small",
                                            "--json", file, "-o", folder.name("out")},
                                           environment);
    INFO(outcome.out << outcome.err);
    CHECK(outcome.code == 1);
    CHECK(outcome.err ==
          "rayclock: building the RTL of 'small', once for all runs\n"
          "rayclock: building the RTL of 'small' for waveforms, once for all runs\n");
    CHECK(outcome.out.find("FIRST DIVERGENCE at cycle ") != std::string::npos);
    CHECK(outcome.out.find("unit tri, link tri_rsp") != std::string::npos);
    CHECK(outcome.out.find("FAILED") != std::string::npos);
    CHECK(outcome.out.find("VERIFIED") == std::string::npos);
    const nlohmann::json report = nlohmann::json::parse(content_of(file)), d = report["first_divergence"];
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
    check_waveform(folder, d);
    // The value passes a queue and a register, back to the statement that computes it.
    const std::string page = content_of(folder.name("out/divergence.html"));
    CHECK(page.find("<dt>made by</dt><dd>rtl/unit/tri/rc_hitdiv.sv:") != std::string::npos);
    CHECK(page.find("<code>assign u_o = (BaryBits+1)") != std::string::npos);

    // An elastic run finds the same value, and its waveform has the RTL alone.
    const ProgramRun elastic = run_program({"verify", "tetra:3", "--size", "24x18", "--config", "small",
                                            "--elastic", "tri", "--json", file, "-o", folder.name("elastic")},
                                           environment);
    INFO(elastic.out << elastic.err);
    CHECK(elastic.code == 1);
    const nlohmann::json e = nlohmann::json::parse(content_of(file))["first_divergence"];
    CHECK(e["expected"] == expected);
    CHECK(e["got"] == got);
    REQUIRE(e["wave"] == folder.name("elastic/divergence.fst"));
    const Waveform wave(e["wave"]);
    const std::uint64_t time = 10 * e["cycle"].get<std::uint64_t>();
    CHECK(wave.at("links.tri_rsp.fires_rtl", time) == "1");
    CHECK(std::stol(wave.at(wave.name_with("links.tri_rsp.u_rtl"), time), nullptr, 2) ==
          std::stol(got.substr(2)));
    CHECK(wave.name_with("links.tri_rsp.u_model").empty());
    CHECK(wave.last() > time);
    check_view(folder.name("elastic"), wave);
    CHECK(!fs::exists(folder.name("elastic/divergence.html")));
    CHECK(elastic.out.find("divergence.gtkw") != std::string::npos);
    CHECK(elastic.out.find("page:") == std::string::npos);

    // render shows the frame of the faulty RTL and does not stop.
    CHECK(run_program({"render", "tetra:3", "--size", "24x18", "--config", "small", "--engine", "rtl", "-o",
                       folder.name("x.png")},
                      environment)
              .code == 0);
}

TEST_CASE("RTL that cannot be built is an error, and leaves nothing in the cache") {
    const TestFolder folder;
    const std::string rtl = broken_rtl(folder, "engine/rc_rank.sv", "endmodule", "endmodul");
    fs::create_directory(folder.name("cache"));
    const ProgramRun outcome = run_program({"verify", "tetra:1", "--size", "8x8"},
                                           {"RAYCLOCK_RTL=" + rtl, "RAYCLOCK_CACHE=" + folder.name("cache")});
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("rc_rank.sv") != std::string::npos);
    for (const auto& [name, bytes] : folder.contents())
        if (name.starts_with("cache/") && !name.starts_with("cache/rc_verilated-"))   // this one is whole
            CHECK(name.ends_with(".lock"));
}
