// The pages of sweep, compare and explain: their figures, hostile names, and their display in a real browser.
#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/cli/view/browser.hpp"

namespace rayclock::test::sweep_compare_explain_pages_test {

using namespace rayclock::test;
using nlohmann::json;

namespace {

const std::string evil = "<script>alert(1)</script>&\"'";

ProgramRun sweep(const TestFolder& folder, std::vector<std::string> more) {
    more.insert(more.begin(),
                {"sweep", "tetra:3", "--size", "32x24", "--axis", "coord_bits=12:20:2", "--axis",
                 "pipelines=1,2,4,8", "--axis", "clock=33,66,90,120,200", "--no-netlist"});
    return run_program(more, {"RAYCLOCK_CACHE=" + folder.name("cache")});
}
/// Writes a page of simulate, 64 x 48.
void simulate(const std::string& file, std::vector<std::string> more) {
    more.insert(more.begin(),
                {"simulate", "gears:2", "--size", "64x48", "--clock", "66", "--no-judge", "--report", file});
    const ProgramRun o = run_program(more);
    INFO(o.err);
    REQUIRE(o.code == 0);
}

}   // namespace

TEST_CASE("a sweep's page has every point's figures as numbers, and merge writes the same") {
    const TestFolder folder;
    REQUIRE(sweep(folder, {"--report", folder.name("a.html"), "--json", folder.name("a.json")}).code == 0);
    const std::string page = content_of(folder.name("a.html"));
    check_alone(page);
    CHECK(page.size() < 900'000);
    const json data = data_of(page, "data"), report = json::parse(content_of(folder.name("a.json")));
    REQUIRE(data["points"].size() == 100);
    for (std::size_t i = 0; i < 100; ++i) {
        const json &shown = data["points"][i], &point = report["points"][i];
        CHECK(shown["values"] == point["values"]);
        CHECK(shown["fps"] == point["clock"]["fps"]);
        CHECK(shown["cycles"] == point["clock"]["cycles"]);
        CHECK(shown["node_hit_rate"] == point["clock"]["frames"][0]["node_hit_rate"]);
        CHECK(shown["pixels_other_primitive"] == point["error"]["pixels_other_primitive"]);
        CHECK(shown["pareto"] == point["pareto"]);
    }
    REQUIRE(run_program({"merge", folder.name("a.json"), "--report", folder.name("b.html")}).code == 0);
    const std::string merged = content_of(folder.name("b.html"));
    CHECK(data_of(merged, "data") == data);
    check_refused(run_program({"merge", folder.name("a.json"), "--report", folder.name("none/b.html")}),
                  {"none/b.html"});
}

TEST_CASE("pages of simulate are compared pixel by pixel") {
    const TestFolder folder;
    const std::string a = folder.name("a.html"), b = folder.name("b.html"), c = folder.name("c.html");
    simulate(a, {});
    simulate(b, {"--set", "contexts=16"});
    const ProgramRun o = run_program({"compare", a, b, "--report", c, "--json", folder.name("c.json")});
    INFO(o.err);
    REQUIRE(o.code == 0);
    const std::string page = content_of(c);
    check_alone(page);
    const json report = json::parse(content_of(folder.name("c.json"))), pixels = report["pixels"];
    CHECK(pixels["faster"].get<int>() + pixels["slower"].get<int>() + pixels["equal"].get<int>() == 64 * 48);
    CHECK(pixels["faster"] > pixels["slower"]);   // fewer rays wait for each other
    // Gains and losses sum to the difference between the totals of both pages.
    const auto cycles = [](const std::string& file) {
        return data_of(content_of(file), "data")["maps"][0]["sum"].get<std::int64_t>();
    };
    CHECK(pixels["cycles_lost"].get<std::int64_t>() - pixels["cycles_gained"].get<std::int64_t>() ==
          cycles(b) - cycles(a));
    CHECK(data_of(page, "data")["differences"] == report["differences"]);
    CHECK(data_of(page, "data")["maps"].size() == 6);

    // A page and a report of the same run agree, so there is no change of pixels.
    const std::string text = data_of(content_of(a), "report").dump();
    const std::string plain = folder.write("a.json", text);
    const json mixed = json::parse(run_program({"compare", a, plain, "--json", "-"}).out);
    CHECK(mixed["differences"].empty());
    CHECK(mixed["pixels"].is_null());

    check_refused(run_program({"compare", a, c}), {"c.html", "not a report of simulate"});
    std::string broken = content_of(a);
    const std::size_t at = broken.find("\"data\":\"", broken.find("\"key\":\"cycles\""));
    broken.replace(at + 20, 8, "AAAAAAAA");
    const std::string bad = folder.write("bad.html", broken);
    check_refused(run_program({"compare", a, bad}), {"bad.html", "cycles of its pixels"});
    check_refused(run_program({"compare", a, folder.write("cut.html", broken.substr(0, at))}), {"cut.html"});
}

TEST_CASE("a pixel's page has its rays' way through the tree") {
    const TestFolder folder;
    const std::string file = folder.name("e.html");
    const ProgramRun o = run_program({"explain", "spheres", "20,14", "--size", "40x30", "--depth", "2",
                                      "--no-judge", "--report", file, "--json", folder.name("e.json")});
    INFO(o.err);
    REQUIRE(o.code == 0);
    const std::string page = content_of(file);
    check_alone(page);
    const json data = data_of(page, "data"), story = json::parse(content_of(folder.name("e.json")));
    CHECK(data_of(page, "explanation") == story);
    REQUIRE(data["rays"].size() == story["rays"].size());
    for (std::size_t r = 0; r < data["rays"].size(); ++r) {
        const json& visits = data["rays"][r]["visits"];
        REQUIRE(visits.size() == story["rays"][r]["node_visits"]);
        std::size_t tests = 0;
        for (std::size_t v = 0; v < visits.size(); ++v) {
            CHECK(visits[v]["parent"] == (v == 0 ? -1 : visits[v]["parent"].get<int>()));
            CHECK(visits[v]["parent"] < int(v));   // a node is reached from an earlier visit
            if (v > 0) CHECK(visits[visits[v]["parent"].get<std::size_t>()]["met"] > 0);
            tests += visits[v]["tests"].get<std::size_t>();
        }
        CHECK(tests == story["rays"][r]["primitive_tests"]);
    }
}

TEST_CASE("the slowest pixels are explained in the report of simulate") {
    const TestFolder folder;
    simulate(folder.name("a.html"), {});
    const json data = data_of(content_of(folder.name("a.html")), "data");
    CHECK(data["explanations"].is_string());
    CHECK(data["slowest"].size() == 100);
}

TEST_CASE("names with markup in them break no page of sweep, compare and explain") {
    const TestFolder folder;
    json values = json::parse(run_program({"config", "default"}).out);
    values["name"] = evil;
    const std::string file = folder.write("evil<b>.json", values.dump());
    const std::string page = folder.name("<i>.html");
    const auto check = [&](const ProgramRun& o) {
        INFO(o.err);
        REQUIRE(o.code == 0);
        CHECK(content_of(page).find("<script>alert") == std::string::npos);
        CHECK(content_of(page).find("<b>.json") == std::string::npos);
        CHECK(content_of(page).find("<i>.html") == std::string::npos);
    };
    check(run_program({"explain", "gears:1", "3,3", "--size", "8x8", "--config", file, "--report", page}));
    check(run_program({"sweep", "gears:1", "--size", "8x8", "--config", file, "--axis", "contexts=8,16",
                       "--no-netlist", "--report", page},
                      {"RAYCLOCK_CACHE=" + folder.name("cache")}));
    const std::string report = folder.name("evil<b>.report.json");
    REQUIRE(run_program({"simulate", "gears:1", "--size", "8x8", "--config", file, "--no-reference", "--json",
                         report})
                .code == 0);
    check(run_program({"compare", report, report, "--report", page}));
    CHECK(content_of(page).find("evil&lt;b&gt;.report.json") != std::string::npos);
}

namespace {

const std::string marks =
    "const marks = id => byId('chart-' + id).querySelectorAll('.mark-rect path, .mark-line path, "
    ".mark-symbol path, "
    ".mark-rule line').length;\n";

}   // namespace

TEST_CASE("a browser draws the pages of sweep, compare and explain, and links their charts", "[slow]") {
    const TestFolder folder;
    const std::string page = folder.name("p.html");
    REQUIRE(sweep(folder, {"--report", page}).code == 0);
    std::string answer = shown(folder, content_of(page), marks + R"(
        const before = marks('parallel') >= 200 && marks('speed') > 100 && marks('alone-1') > 100;
        const wide = document.documentElement.scrollWidth <= document.documentElement.clientWidth;
        byId('points').querySelectorAll('tbody tr')[42].dispatchEvent(new MouseEvent('mouseover'));
        await new Promise(done => setTimeout(done, 300));
        const thick = [...document.querySelectorAll('#chart-parallel .mark-line path')].filter(p =>
            p.getAttribute('stroke-width') === '3.5').length;
        const box = byId('filters').querySelector('input');
        box.click();
        await new Promise(done => setTimeout(done, 300));
        const hidden = [...document.querySelectorAll('#chart-parallel .mark-line path')].filter(p =>
            p.getAttribute('stroke-opacity') === '0').length;
        return [document.body.dataset.shown, before, wide, picked, thick, byId('picked').textContent.split(':')[0], hidden].join(' ');)");
    if (answer.empty()) return;
    CHECK(answer == "yes true true 42 1 coord_bits 16, pipelines 1, clock 90 20");

    simulate(folder.name("a.html"), {});
    simulate(folder.name("b.html"), {"--set", "contexts=16"});
    REQUIRE(run_program({"compare", folder.name("a.html"), folder.name("b.html"), "--report", page}).code ==
            0);
    answer = shown(folder, content_of(page), marks + R"(
        const image = byId('change').getContext('2d').getImageData(0, 0, 64, 48).data, colours = new Set();
        for (let i = 0; i < image.length; i += 4) colours.add(image.slice(i, i + 3).join());
        const box = byId('change').getBoundingClientRect();
        byId('change').dispatchEvent(new PointerEvent('pointermove',
            { clientX: box.left + box.width * 0.501, clientY: box.top + box.height * 0.501 }));
        const map = maps[byId('figure').value];
        let off = 0;
        map.change.forEach((change, i) => changeColour(change / map.end).forEach((c, k) =>
            off = Math.max(off, Math.abs(image[4 * i + k] - c))));
        return [document.body.dataset.shown, marks('effects') >= 40, colours.size > 10, off <= 1,
            byId('pixel').textContent.split(':')[0]].join(' ');)");
    CHECK(answer == "yes true true true Pixel 32, 24");

    REQUIRE(run_program({"explain", "gears:2", "30,24", "--size", "64x48", "--report", page}).code == 0);
    answer = shown(folder, content_of(page), marks + R"(
        const visits = data.rays[0].visits.length;
        return [document.body.dataset.shown, marks('tree') === 2 * visits - 1, marks('steps') >= visits].join(' ');)");
    CHECK(answer == "yes true true");

    // A click on a pixel, or on its row, shows its explanation.
    answer = shown(folder, content_of(folder.name("a.html")), R"(
        const row = document.querySelector('#pixels tbody tr');
        row.click();
        const text = byId('explanation').textContent, at = row.cells[0].textContent;
        return [Object.keys(explanations).length, byId('explanation').hidden, text.includes(`pixel (${at})`),
            text.includes('what the cycles were for')].join(' ');)");
    CHECK(answer == "100 false true true");
}

TEST_CASE("every page opens in under a second", "[slow]") {
    const TestFolder folder;
    if (!is_installed("chromium")) {
        WARN("chromium is not installed");
        return;
    }
    REQUIRE(sweep(folder, {"--report", folder.name("sweep.html")}).code == 0);
    for (const char* name : {"a.html", "b.html"})
        REQUIRE(
            run_program({"simulate", "gears:8", "--clock", "66", "--no-judge", "--report", folder.name(name)})
                .code == 0);
    REQUIRE(run_program({"compare", folder.name("a.html"), folder.name("b.html"), "--report",
                         folder.name("compare.html")})
                .code == 0);
    REQUIRE(
        run_program({"explain", "gears:8", "255,190", "--no-judge", "--report", folder.name("explain.html")})
            .code == 0);
    for (const char* name : {"sweep.html", "a.html", "compare.html", "explain.html"}) {
        const std::string page = content_of(folder.name(name));
        CHECK(page.size() < 3'000'000);
        PageTimes best = time_to_open(folder, page);   // the best of five, because other jobs may run
        for (int again = 0; again < 4 && best.whole >= 1000; ++again) {
            const PageTimes times = time_to_open(folder, page);
            if (times.whole < best.whole) best = times;
        }
        WARN(name << ": first screen after " << best.opened << " ms, all charts after " << best.whole
                  << " ms, " << page.size() << " bytes");
        CHECK(best.opened < 1000);
        CHECK(best.whole < 1000);
    }
}

}   // namespace rayclock::test::sweep_compare_explain_pages_test
