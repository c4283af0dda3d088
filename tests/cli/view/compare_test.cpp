// rayclock compare: changes are found, judged, and bounded.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

std::string report(const TestFolder& folder, const char* name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"simulate", "gears:2", "--size", "40x30",
                                       "--clock",  "66,200",  "--json", folder.name(name)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    REQUIRE(run_program(arguments).code == 0);
    return folder.name(name);
}

json compared(std::vector<std::string> arguments, int code) {
    arguments.insert(arguments.begin(), "compare");
    arguments.insert(arguments.end(), {"--json", "-"});
    const ProgramRun outcome = run_program(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.code == code);
    return json::parse(outcome.out);
}

/// Returns 0 for key figures, as listed in docs/guide/report.md.
int rank_of(const std::string& figure, const json& verdict) {
    const std::vector<std::string> first{
        "clocks.66.cycles", "clocks.66.fps",         "clocks.66.dram_bytes", "clocks.200.cycles",
        "clocks.200.fps",   "clocks.200.dram_bytes", "error.psnr_db",        "error.pixels_other_primitive",
        "judge.wrong"};
    if (std::find(first.begin(), first.end(), figure) != first.end()) return 0;
    return verdict.is_null() ? 2 : 1;
}

}   // namespace

TEST_CASE("compare finds what changed, says which way, and fails beyond a bound") {
    const TestFolder folder;
    const std::string a = report(folder, "a.json", {}), again = report(folder, "again.json", {}),
                      b = report(folder, "b.json", {"--set", "node_sets=1", "--set", "contexts=32"});
    const json same = compared({a, again, "--max-worse", "0%"}, 0);
    CHECK(same["differences"].empty());
    CHECK(same["settings"].empty());
    CHECK(same["equal"] > 100);

    const json worse = compared({a, b, "--max-worse", "1%"}, 1);
    CHECK(worse["settings"].size() == 3);   // and the bound at 66 MHz
    CHECK(worse["settings"][1] == json{{"key", "config.contexts"}, {"values", {"64", "32"}}});
    const json first = json::parse(content_of(a)), second = json::parse(content_of(b));
    bool found = false;
    std::pair<int, double> last{0, -1e300};
    for (const json& d : worse["differences"]) {
        // Key figures come first, then figures with a verdict, then the rest. Each group is sorted by
        // descending change.
        const std::string figure = d["figure"];
        const int rank = rank_of(figure, d["verdict"]);
        const std::pair<int, double> place{rank,
                                           d["change"].is_null() ? -1 : -std::abs(d["change"].get<double>())};
        CAPTURE(figure);
        CHECK(place >= last);
        last = place;
        if (figure != "clocks.200.cycles") continue;
        found = true;
        CHECK(d["name"] == "cycles at 200 MHz");
        const double before = first["clocks"][1]["cycles"], after = second["clocks"][1]["cycles"];
        CHECK(d["values"] == json{before, after});
        CHECK(d["change"].get<double>() == Approx((after - before) / before));
        CHECK(d["verdict"] == "worse");
    }
    CHECK(found);
    CHECK(std::find(worse["worse"].begin(), worse["worse"].end(), "clocks.66.cycles") !=
          worse["worse"].end());
    const json better = compared({b, a, "--max-worse", "1%", "--figure", "clocks.*.cycles"}, 0);
    CHECK(better["worse"].empty());
    compared({a, b, "--max-worse", "99%", "--figure", "clocks.66.fps"}, 0);
    compared({a, b, "--max-worse", "0%", "--figure", "clocks.66.fps"}, 1);

    const ProgramRun text = run_program({"compare", a, b});
    CHECK(text.code == 0);
    for (const char* words : {"config.node_sets", "clocks.66.cycles", "worse", "--all prints the rest"}) {
        INFO(words);
        CHECK(text.out.find(words) != std::string::npos);
    }
    CHECK(run_program({"compare", a, b, again, "--all"}).out.find("clocks.66.cycles") != std::string::npos);
}

TEST_CASE("compare refuses a file that is not a report") {
    const TestFolder folder;
    const std::string a = report(folder, "a.json", {"--no-reference"}),
                      empty = folder.write("empty.json", "{}"), broken = folder.write("broken.json", "{"),
                      list = folder.write("list.json", "[1]");
    check_refused(run_program({"compare", a}), {"two reports"});
    check_refused(run_program({"compare", a, empty}), {"empty.json", "not a report", "'scene'"});
    check_refused(run_program({"compare", a, list}), {"list.json", "not a report"});
    check_refused(run_program({"compare", a, broken}), {"broken.json"});
    const auto changed = [&](const char* pointer, const json& value) {   // as another version might write it
        json other = json::parse(content_of(a));
        other[json::json_pointer(pointer)] = value;
        return folder.write("other.json", other.dump());
    };
    check_refused(run_program({"compare", a, changed("/clocks/0/mhz", "x")}), {"other.json", "'mhz'"});
    check_refused(run_program({"compare", a, changed("/clocks/0", json::object())}),
                  {"other.json", "'mhz' and 'cycles'"});
    check_refused(run_program({"compare", a, changed("/frame", 3)}),
                  {"other.json", "'frame' is not an object"});
    check_refused(run_program({"compare", a, folder.name("missing.json")}), {"missing.json"});
    check_refused(run_program({"compare", a, a, "--max-worse", "much"}), {"--max-worse", "much"});
    check_refused(run_program({"compare", a, a, "--figure", "x"}), {"--figure", "--max-worse"});
}
