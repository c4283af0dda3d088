// Two levels from the command line.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

Outcome drawn(std::vector<std::string> more) {
    static const Folder folder;
    more.insert(more.begin(), {"render", "--size", "32x24", "-o", folder.name("a.png")});
    return run_program(more);
}

json report(std::vector<std::string> more) {
    more.insert(more.end(), {"--json", "-"});
    const Outcome outcome = drawn(more);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(outcome.out);
}

}   // namespace

TEST_CASE("render --levels 2 keeps each mesh once, and says what its rays did") {
    const json two = report({"gearbox:3", "--levels", "2"}), again = report({"gearbox:3", "--levels", "2"});
    CHECK(two["levels"]["instances"] == 28);   // with the ground
    CHECK(two["levels"]["meshes"] == 2);
    CHECK(two["levels"]["bytes"].get<int>() < 100'000);
    CHECK(two["levels"]["instances_entered"].get<int>() > 100);
    CHECK(two["levels"]["node_steps"].get<int>() > 1000);
    CHECK(two["digest"] == again["digest"]);
    CHECK(two["digest"] == report({"gearbox:3", "--levels", "2", "--threads", "1"})["digest"]);
    CHECK_FALSE(two.contains("cycles"));
    CHECK(report({"gearbox:3"})["digest"] == report({"gears:3"})["digest"]);
}

TEST_CASE("render --levels 2 refuses what it cannot draw") {
    check_refused(drawn({"gearbox:1", "--levels", "2", "--engine", "rtl"}), {"--levels 2", "--engine model"});
    check_refused(drawn({"gearbox:1", "--levels", "2", "--engine", "reference"}), {"--levels 2"});
    check_refused(drawn({"gearbox:1", "--levels", "2", "--depth", "2"}), {"--levels 2", "--levels 1"});
    check_refused(drawn({"gearbox:1", "--levels", "2", "--set", "shading=1"}), {"two levels", "shading=0"});
    check_refused(drawn({"gearbox:1", "--levels", "2", "--set", "structure=kd"}), {"two levels"});
    check_refused(drawn({"spheres", "--levels", "2"}), {"two levels", "no true spheres"});
    check_refused(drawn({"gearbox:1", "--levels", "3"}), {"--levels", "3"});
}
