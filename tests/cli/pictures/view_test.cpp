// --eye, --at, --fov, --orbit: the view of a scene.
#include <catch2/catch.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

json simulated(std::vector<std::string> more) {
    more.insert(more.begin(),
                {"simulate", "gears:2", "--size", "32x24", "--clock", "66", "--no-judge", "--json", "-"});
    const ProgramRun outcome = run_program(more);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(outcome.out);
}

void check_near(const json& a, const json& b) {
    for (std::size_t k = 0; k < 3; ++k) CHECK(a[k].get<double>() == Approx(b[k].get<double>()).margin(1e-9));
}

}   // namespace

TEST_CASE("a view is the scene's own except for the given options") {
    const json own = simulated({});
    const json typed = simulated({"--eye", "3,-4,2.5", "--at=-1,0,1e-1", "--fov", "30"});
    check_near(typed["camera"]["eye"], json{3, -4, 2.5});
    check_near(typed["camera"]["at"], json{-1, 0, 0.1});
    CHECK(typed["camera"]["fov_degrees"] == 30);
    CHECK(typed["camera"]["up"] == own["camera"]["up"]);
    CHECK(typed["digest"] != own["digest"]);
    CHECK(simulated({"--fov", own["camera"]["fov_degrees"].dump()})["digest"] == own["digest"]);
    // A full turn returns to the start. Half a turn mirrors the eye in the up axis.
    check_near(simulated({"--orbit", "360"})["camera"]["eye"], own["camera"]["eye"]);
    const json side = simulated({"--eye", "1,2,3", "--at", "0,0,0", "--orbit", "180"})["camera"];
    double along = 0;
    const double arm[] = {1, 2, 3};
    for (std::size_t k = 0; k < 3; ++k) along += arm[k] * side["up"][k].get<double>();
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k) length += side["up"][k].get<double>() * side["up"][k].get<double>();
    for (std::size_t k = 0; k < 3; ++k)
        CHECK(side["eye"][k].get<double>() ==
              Approx(2 * along / length * side["up"][k].get<double>() - arm[k]).margin(1e-9));
}

TEST_CASE("every command that draws a scene takes a view, and the machine is still right") {
    const TestFolder folder;
    const std::vector<std::string> view{"--orbit", "50", "--size", "24x18"};
    const auto runs = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), view.begin(), view.end());
        const ProgramRun outcome = run_program(arguments);
        INFO(outcome.err);
        CHECK(outcome.code == 0);
    };
    runs({"simulate", "gears:1", "--clock", "66"});   // with the judge
    runs({"render", "gears:1", "-o", folder.name("a.png")});
    runs({"explain", "gears:1", "3,4"});
    runs({"trace", "gears:1", "--cycles", "100:110", "-o", folder.name("a.kanata")});
    runs({"sweep", "gears:1", "--axis", "contexts=8,16", "--no-netlist"});
}

TEST_CASE("a ground is two triangles of the scene that is drawn, and the camera stays") {
    const json own = simulated({}), ground = simulated({"--ground"});
    CHECK(ground["camera"] == own["camera"]);
    CHECK(ground["scene"]["triangles"].get<int>() == own["scene"]["triangles"].get<int>() + 2);
    CHECK(ground["digest"] != own["digest"]);
    const ProgramRun finished = run_program(
        {"simulate", "balls:1", "--ground", "--depth", "2", "--size", "24x18", "--clock", "66"});   // judged
    INFO(finished.err);
    CHECK(finished.code == 0);
    check_refused(run_program({"render", "gearbox:1", "--set", "levels=2", "--ground", "-o", "a.png"}),
                  {"--ground", "levels=1"});
}

TEST_CASE("an illegal view is refused with its option and value") {
    const auto refused = [](std::vector<std::string> more, const std::vector<std::string>& words) {
        more.insert(more.begin(), {"simulate", "gears:1"});
        check_refused(run_program(more), words);
    };
    refused({"--eye", "1,2"}, {"--eye", "1,2", "x,y,z"});
    refused({"--at", "1,2,x"}, {"--at", "1,2,x"});
    refused({"--at", "1,2,inf"}, {"--at", "1,2,inf"});
    refused({"--fov", "180"}, {"--fov", "180"});
    refused({"--orbit", "400"}, {"--orbit", "-360..360", "400"});
    refused({"--eye", "1,1,1", "--at", "1,1,1"}, {"eye", "are the same"});
    for (const char* pixels :
         {"1", "1,2,3", "a,0,4x4", "0,0,4x", "0,0,4x4x4", "0,0,4x4,5", "99999999999,0,4x4"})
        refused({"--pixels", pixels}, {"--pixels", pixels, "400,300,64x48"});
    for (const char* pixels :
         {"-1,0,4x4", "0,-1,4x4", "0,0,0x4", "0,0,4x0", "0,0,25x4", "21,0,4x4", "0,15,4x4"})
        refused({"--size", "24x18", "--pixels", pixels}, {"--pixels", pixels, "does not lie in", "24x18"});
}

TEST_CASE("a part of a picture has its rays, and the report says which part it is") {
    const json part = simulated({"--pixels", "18,10,12x9"});
    CHECK(part["frame"]["width"] == 12);
    CHECK(part["frame"]["height"] == 9);
    CHECK(part["camera"]["window"] == json{{"x", 18}, {"y", 10}, {"whole_width", 32}, {"whole_height", 24}});
    CHECK(simulated({})["camera"]["window"].is_null());
}

TEST_CASE("a part of a picture can be given by two corners, or by the cycles in which its pixels are drawn") {
    const json part = simulated({"--pixels", "18,10..29,18"});
    CHECK(part["camera"]["window"] == json{{"x", 18}, {"y", 10}, {"whole_width", 32}, {"whole_height", 24}});
    CHECK(part["frame"] == json{{"width", 12}, {"height", 9}});

    const auto verified = [](const std::string& option, const std::string& value) {
        const ProgramRun outcome =
            run_program({"verify", "gears:1", "--size", "48x32", "--set", "tile_bits=2", "--set",
                         "contexts=16", option, value, "--json", "-"});
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        return json::parse(outcome.out);
    };
    const json all = verified("--pixels", "0,0,48x32");
    const auto cycles = all["clocks"][0]["cycles"].get<std::uint64_t>();
    const json whole = verified("--cycles", fmt::format("0:{}", cycles));
    CHECK(whole["camera"]["window"] == all["camera"]["window"]);
    CHECK(whole["digest"] == all["digest"]);
    // The first pixels lie in the first tiles, the last ones in the last tile.
    const json first = verified("--cycles", "0:60"),
               last = verified("--cycles", fmt::format("{}:999999999", cycles - 20));
    CHECK(first["camera"]["window"]["x"] == 0);
    CHECK(first["camera"]["window"]["y"] == 0);
    CHECK(first["frame"]["width"].get<int>() * first["frame"]["height"].get<int>() <= 32);
    CHECK(last["camera"]["window"]["x"].get<int>() + last["frame"]["width"].get<int>() == 48);
    CHECK(last["camera"]["window"]["y"].get<int>() + last["frame"]["height"].get<int>() == 32);
    CHECK(last["frame"]["width"].get<int>() * last["frame"]["height"].get<int>() <= 32);

    const auto refused = [](std::vector<std::string> more, const std::vector<std::string>& words) {
        more.insert(more.begin(), {"verify", "gears:1", "--size", "24x18"});
        check_refused(run_program(more), words);
    };
    refused({"--pixels", "3,3..2,9"}, {"--pixels", "upper left"});
    refused({"--pixels", "3,3..24,9"}, {"--pixels", "24,9", "23,17"});
    refused({"--pixels", "3;3"}, {"--pixels", "3;3", "400,300,64x48"});
    refused({"--cycles", "5"}, {"--cycles", "2000:3000"});
    refused({"--cycles", "9:9"}, {"holds no cycle"});
    refused({"--cycles", "-1:9"}, {"--cycles", "-1:9"});
    refused({"--cycles", "99999999:999999999"}, {"the frame ends after"});
    refused({"--cycles", "0:9", "--pixels", "0,0,4x4"}, {"--pixels and --cycles"});
    check_refused(run_program({"verify", "--torture", "--cycles", "0:9"}), {"--torture", "--cycles"});
    check_refused(run_program({"verify", "--torture", "--pixels", "0,0"}), {"--torture", "--pixels"});
}

TEST_CASE("a part of a picture is judged with the texture levels of the whole picture") {
    // Light that falls through leaves: with the levels of a picture of 20 rows, two of these pixels are bugs.
    const ProgramRun outcome = run_program({"simulate", "room", "--depth", "2", "--size", "1024x768",
                                            "--pixels", "256,700,256x20", "--clock", "66", "--json", "-"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const json report = json::parse(outcome.out);
    CHECK(report["error"]["causes"]["bug"] == 0);
    CHECK(report["error"]["causes"]["texture"] > 1000);
}
