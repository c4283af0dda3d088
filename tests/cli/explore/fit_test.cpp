// rayclock fit: its file, its report, its message if no configuration is good enough, and its refusals.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>
#include <set>

#include "model/core/parameters.hpp"
#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

/// Returns a teapot on a lawn so large that the teapot has only a few lattice points.
std::string stadium(double half) {
    const json ground{
        {"vertices", {{-half, -half, -1}, {half, -half, -1}, {half, half, -1}, {-half, half, -1}}},
        {"triangles", {{0, 1, 2}, {0, 2, 3}}}};
    return json{
        {"camera", {{"eye", {0, 6, 12}}, {"at", {0, 1, 0}}, {"fov_degrees", 40}}},
        {"materials", {{"lawn", {{"colour", {0.3, 0.6, 0.3}}}}, {"china", {{"colour", {0.9, 0.9, 0.8}}}}}},
        {"meshes", {{"pot", {{"builtin", "teapot:3"}}}, {"ground", ground}}},
        {"objects", {{{"mesh", "pot"}, {"material", "china"}}, {{"mesh", "ground"}, {"material", "lawn"}}}}}
        .dump();
}

}   // namespace

TEST_CASE("fit writes a configuration that verify passes with", "[long]") {
    const std::string scene = GENERATE("teapot:3", "cornell");
    const TestFolder folder;
    const std::string file = folder.name("fitted.json");
    const ProgramRun fit =
        run_program({"fit", scene, "--size", "64x48", "--max-error", "0.5%", "-o", file, "--json", "-"});
    INFO(fit.err);
    REQUIRE(fit.code == 0);
    CHECK(fit.err.empty());
    const json report = json::parse(fit.out), written = json::parse(content_of(file));

    // The file states every parameter, and equals the report's configuration.
    CHECK(written == report.at("config"));
    CHECK(written.at("name") == (scene == "cornell" ? "cornell" : "teapot-3"));
    for (const rayclock::Parameter& p : rayclock::parameters()) CHECK(written.contains(p.key));
    for (const json& p : report.at("parameters")) {
        CHECK(written.at(p.at("key").get<std::string>()) == p.at("value"));
        CHECK(std::set<std::string>{"correctness", "accuracy", "work"}.count(p.at("for")) == 1);
        CHECK(!p.at("one_step_below").get<std::string>().empty());
    }
    CHECK(report.at("parameters").size() == 10);
    CHECK(100 * report.at("error").at("pixels_other_primitive").get<double>() <= 0.5 * 64 * 48);
    CHECK(report.at("error").at("work").get<double>() <= 1.02 * report.at("widest").at("work").get<double>());
    CHECK(report.at("cost").at("fitted").at("total") < report.at("cost").at("base").at("total"));
    const json &needs = report.at("needs"), &ranges = report.at("ranges");
    CHECK(needs.at("lines").get<int>() * 64 == needs.at("bytes").get<int>());
    CHECK(needs.at("stack_need").get<int>() <= needs.at("stack_depth").get<int>());
    CHECK(needs.at("constants").size() == 3);
    CHECK(!report.at("units").at("needed").empty());
    CHECK(ranges.at("overflow_possible") == false);
    CHECK(ranges.at("signals").size() > 60);
    for (const json& s : ranges.at("signals")) {
        INFO(s);
        CHECK((s.at("bits_needed") <= s.at("bits_there")) == (s.at("verdict") == "fits"));
        CHECK(s.at("from").is_string());
        CHECK(s.at("to").is_string());
    }

    // The same run in words gives the same file.
    const std::string again = folder.name("again.json");
    const ProgramRun words =
        run_program({"fit", scene, "--size", "64x48", "--max-error", "0.5 %", "-o", again});
    CHECK(words.code == 0);
    CHECK(content_of(again) == content_of(file));
    for (const char* word : {"no overflow possible", "coord_bits", "one step below", "memory image", "s3_det",
                             "rayclock verify"}) {
        INFO(word);
        CHECK(words.out.find(word) != std::string::npos);
    }
    const ProgramRun verify =
        run_program({"verify", scene, "--size", "64x48", "--config", file, "--json", "-"});
    INFO(verify.err);
    CHECK(verify.code == 0);
    const json verified = json::parse(verify.out);
    CHECK(verified.at("value_mismatches") == 0);
    CHECK(verified.at("reference").at("pixels_other_primitive") ==
          report.at("error").at("pixels_other_primitive"));
    // A picture larger than the fitted size is refused with a sentence.
    check_refused(run_program({"simulate", scene, "--size", "400x3", "--config", file}),
                  {"pixel_bits", "9 bits"});
}

TEST_CASE("fit keeps a PSNR, and says what a scene cannot have") {
    const TestFolder folder;
    const std::string file = folder.name("fitted.json");
    const ProgramRun good = run_program({"fit", "tetra:3", "--size", "64x48", "--max-error", "1%",
                                         "--min-psnr", "35", "-o", file, "--json", "-"});
    REQUIRE(good.code == 0);
    const json report = json::parse(good.out);
    CHECK((report.at("error").at("psnr_db").is_null() || report.at("error").at("psnr_db") >= 35));
    CHECK(report.at("bounds").at("min_psnr_db") == 35);

    const std::string scene = folder.write("stadium.json", stadium(400000)),
                      never = folder.name("never.json");
    const ProgramRun hopeless =
        run_program({"fit", scene, "--size", "96x72", "--max-error", "0.5%", "-o", never});
    CHECK(hopeless.code == 1);
    CHECK(hopeless.out.empty());
    CHECK(folder.contents().count("never.json") == 0);
    for (const char* word :
         {"no width keeps the bound", "N = 20", "material 'lawn' (2 triangles)", "without that N = 1"}) {
        INFO(word << " in: " << hopeless.err);
        CHECK(hopeless.err.find(word) != std::string::npos);
    }
    CHECK(std::count(hopeless.err.begin(), hopeless.err.end(), '\n') == 1);
    // This scene has no triangles, so none can be too large.
    const ProgramRun round =
        run_program({"fit", "spheres", "--depth", "1", "--size", "16x12", "--min-psnr", "150", "-o", never});
    CHECK(round.code == 1);
    CHECK(round.err.find("no width keeps the bound") != std::string::npos);
    // Planes beyond the lattice need nine bits of an origin.
    CHECK(run_program(
              {"fit", "scenes/pond.json", "--depth", "2", "--size", "16x12", "-o", folder.name("pond.json")})
              .code == 0);
    const ProgramRun fine = run_program({"fit", folder.write("garden.json", stadium(20)), "--size", "96x72",
                                         "--max-error", "0.5%", "-o", never});
    INFO(fine.err);
    CHECK(fine.code == 0);
}

TEST_CASE("fit refuses goals that make no sense, and writes nothing") {
    const TestFolder folder;
    const std::string never = folder.name("never.json");
    const auto fit = [&](std::vector<std::string> more, const std::vector<std::string>& words) {
        std::vector<std::string> arguments{"fit", "tetra:1", "-o", never};
        arguments.insert(arguments.end(), more.begin(), more.end());
        std::string line;
        for (const std::string& a : arguments) line += a + " ";
        INFO(line);
        check_refused(run_program(arguments), words);
        CHECK(folder.contents().empty());
    };
    for (const char* text : {"0%", "0 %", "-1%", "-0.1 %", "100%", "200 %", "200%", "1e3%"})
        fit({std::string("--max-error=") + text}, {"--max-error", text, "100 %"});
    for (const char* text :
         {"0.1", "nan%", "inf%", "%", " %", "abc", "0,1%", "0.1%%", "0x1%", "1% 2%", "0.1 % "})
        fit({std::string("--max-error=") + text}, {"--max-error", "not a percentage"});
    fit({"--max-error="}, {"--max-error"});
    fit({"--max-work=100%"}, {"--max-work", "100 %"});
    fit({"--max-work=-1%"}, {"--max-work"});
    fit({"--max-work", "much"}, {"--max-work", "'much'"});
    for (const char* text : {"0", "-3", "201", "nan", "inf"})
        fit({std::string("--min-psnr=") + text}, {"--min-psnr"});
    fit({"--min-psnr=loud"}, {"loud"});
    fit({"--size", "0x5"}, {"0 x 5"});
    fit({"--set", "primitive_test=woop"}, {"primitive_test", "woop"});
    fit({"--config", "defaul"}, {"'defaul'"});
    fit({"--json", folder.name("no/such.json")}, {"such.json"});
    fit({"--device", "lfe5u-86"}, {"'lfe5u-86'", "lfe5u-85"});
    fit({"--device", "lfe5u-85", "--fill", "0%"}, {"--fill", "0%"});
    fit({"--device", "lfe5u-85", "--fill", "all"}, {"--fill", "'all'"});
    fit({"--device", "lfe5u-85", "--clock", "66,90"}, {"--clock", "'66,90'"});
    fit({"--device", "lfe5u-85", "--placer", "heep"}, {"--placer", "'heep'", "did you mean 'heap'"});
    fit({"--device", "lfe5u-85", "--no-route", "--router", "router2"}, {"--router", "--no-route"});
    for (const std::vector<std::string>& alone : {std::vector<std::string>{"--fill", "50%"},
                                                  {"--clock", "66"},
                                                  {"--no-route"},
                                                  {"--fresh"},
                                                  {"--placements", "1"}})
        fit(alone, {alone[0], "no effect without --device"});
    check_refused(run_program({"fit", "tetra:1"}), {"--output"});
    check_refused(run_program({"fit", "tetra:1", "-o", folder.name("no/such.json")}), {"such.json"});
    check_refused(run_program({"fit", "no_such_scene", "-o", never}), {"no_such_scene"});
}
