// rayclock trace: written files and refused requests.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"
#include "tests/cli/view/waveform.hpp"

using namespace rayclock::test;
using nlohmann::json;

TEST_CASE("trace writes a timeline for each viewer") {
    const TestFolder folder;
    for (const char* name : {"a.kanata", "a.pftrace", "a.fst"}) {
        const ProgramRun outcome = run_program({"trace", "gears:2", "--size", "40x30", "--cycles",
                                                "2000:2100", "-o", folder.name(name), "--json", "-"});
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        const json report = json::parse(outcome.out);
        CHECK(report["rays"] > 10);
        CHECK(report["stays"] > report["rays"]);
        CHECK(report["unit_spans"] >= 11);
    }
    CHECK(content_of(folder.name("a.kanata")).starts_with("Kanata\t0004\nC=\t2000\n"));
    CHECK(content_of(folder.name("a.pftrace")).size() > 10'000);
    const Waveform wave(folder.name("a.fst"));
    CHECK(wave.first() >= 20'000);
    CHECK(wave.last() < 21'010);
    CHECK(wave.names().contains("pipeline_0.box"));
    const std::string view = content_of(folder.name("a.gtkw"));
    CHECK(view.find("[dumpfile] \"a.fst\"") != std::string::npos);
    CHECK(view.find("\npipeline_0.box\n") != std::string::npos);
    const ProgramRun pixels = run_program(
        {"trace", "gears:2", "--size", "40x30", "--pixels", "20,14..21,15", "-o", folder.name("b.kanata")});
    CHECK(pixels.code == 0);
    CHECK(pixels.out.starts_with("gears:2: 4 rays, "));
}

TEST_CASE("trace refuses what it cannot show") {
    const TestFolder folder;
    const std::string out = folder.name("a.kanata");
    const auto refused = [&](std::vector<std::string> more, const std::vector<std::string>& words) {
        std::vector<std::string> arguments{"trace", "gears:1", "--size", "40x30", "-o", out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        check_refused(run_program(arguments), words);
    };
    refused({}, {"--cycles FIRST:LAST", "--pixels"});
    refused({"--cycles", "5"}, {"--cycles", "2000:3000"});
    refused({"--cycles", "5:5"}, {"holds no cycle"});
    refused({"--cycles", "0:2000000"}, {"more than 1000000"});
    refused({"--cycles", "90000000:90000001"}, {"the frame ends after"});
    refused({"--pixels", "40,0"}, {"40,0", "39,29"});
    refused({"--pixels", "5,5..4,6"}, {"upper left"});
    refused({"--cycles", "5:9", "--rays", "primary"}, {"primary", "reflection"});
    refused({"--cycles", "5:9", "--rays", "shadow,refraction"}, {"--rays", "only camera rays", "--depth"});
    check_refused(run_program({"trace", "gears:1", "--cycles", "5:9", "-o", folder.name("a.vcd")}),
                  {"a.vcd", ".kanata", ".pftrace", ".fst"});
    CHECK(folder.contents().empty());
}
