// Two levels on the command line.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

ProgramRun drawn(std::vector<std::string> more) {
    static const TestFolder folder;
    more.insert(more.begin(), {"render", "--size", "32x24", "-o", folder.name("a.png")});
    return run_program(more);
}

json report(std::vector<std::string> more) {
    more.insert(more.end(), {"--json", "-"});
    const ProgramRun outcome = drawn(more);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(outcome.out);
}

}   // namespace

TEST_CASE("a machine of two levels keeps each mesh once") {
    const std::vector<std::string> two{"gearbox:3", "--set", "levels=2"};
    const json model = report(two);
    CHECK(model["cycles"].get<int>() > 1000);
    CHECK(model["config"]["levels"] == 2);
    CHECK(model["digest"] == report(two)["digest"]);
    CHECK(model["digest"] != report({"gearbox:3"})["digest"]);
    CHECK(report({"gearbox:3"})["digest"] == report({"gears:3"})["digest"]);
}

TEST_CASE("planes and true spheres of a scene are drawn in two levels as in one") {
    const TestFolder folder;
    const auto picture = [&](const std::string& levels) {
        const std::string file = folder.name("levels" + levels + ".png");
        const ProgramRun outcome =
            run_program({"render", "spheres", "--size", "32x24", "--set", "levels=" + levels, "-o", file});
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        return content_of(file);
    };
    CHECK(picture("2") == picture("1"));
}

TEST_CASE("a setting counts, whether the configuration shades or the scene makes it shade") {
    for (const std::string config : {"default", "ulx3s-shaded"}) {
        const json made = report({"gearbox:1", "--config", config, "--depth", "2", "--set", "levels=2"});
        CHECK(made["config"]["levels"] == 2);
        CHECK(made["config"]["shading"] == 1);
    }
}

TEST_CASE("two levels refuse what they cannot draw") {
    const auto refused = [](std::vector<std::string> more, const std::vector<std::string>& words) {
        more.insert(more.end(), {"--set", "levels=2"});
        check_refused(drawn(more), words);
    };
    refused({"gearbox:1", "--ground", "--depth", "2"}, {"--ground", "levels=2"});
    refused({"gearbox:1", "--set", "structure=none"}, {"levels=2", "structure", "none"});
    refused({"gearbox:1", "--set", "primitive_test=sheared"}, {"levels=2", "primitive_test=exact"});
    check_refused(drawn({"gearbox:1", "--set", "levels=3"}), {"levels", "1..2", "3"});
}
