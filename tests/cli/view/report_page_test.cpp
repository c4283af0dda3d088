// simulate --report: one file with every figure, for any name of the scene, displayed by a real browser.
#include <catch2/catch.hpp>

#include <algorithm>

#include <nlohmann/json.hpp>
#include <zlib.h>

#include "tests/cli/view/browser.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

/// Returns a map's value of every pixel, unpacked by zlib and the test's own decoder.
std::vector<std::uint32_t> values_of(const nlohmann::json& map, std::size_t pixels) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<Bytef> packed;
    std::uint32_t bits = 0, held = 0;
    for (const char c : map["data"].get<std::string>()) {
        if (c == '=') break;
        bits = bits << 6 | std::uint32_t(digits.find(c));
        held += 6;
        if (held >= 8) packed.push_back(Bytef(bits >> (held -= 8)));
    }
    const std::size_t bytes = map["bytes"];
    std::vector<Bytef> planes(bytes * pixels);
    uLongf size = uLongf(planes.size());
    REQUIRE(uncompress(planes.data(), &size, packed.data(), uLong(packed.size())) == Z_OK);
    REQUIRE(size == planes.size());
    std::vector<std::uint32_t> values(pixels);
    for (std::size_t i = 0; i < bytes * pixels; ++i)
        values[i % pixels] += std::uint32_t(planes[i]) << 8 * (i / pixels);
    return values;
}

/// Returns the report without values that differ between runs.
json lasting(json report) {
    report.erase("host");
    report["compile"].erase("seconds");
    if (report["judge"].is_object()) report["judge"].erase("seconds");
    return report;
}

void check_figures(const json& report, const json& data) {
    const json& pixels = report["frame"];
    CHECK(data["cycles"] == report["clocks"][0]["cycles"]);
    std::map<std::string, std::uint64_t> sums;
    for (const json& map : data["maps"]) sums[map["key"]] = map["sum"];
    CHECK(sums["visits"] == report["work"]["node_steps"]);
    CHECK(sums["tests"] == report["work"]["triangle_tests"]);
    CHECK(sums["bytes"] == report["clocks"][0]["dram_bytes"]);
    CHECK(data["width"] == pixels["width"]);
    std::uint64_t cycles = 0, kinds = 0, steps = 0;
    for (const json& window : data["windows"]) cycles += window["cycles"].get<std::uint64_t>();
    CHECK(cycles == data["cycles"]);
    for (const auto& [name, kind] : report["work_by_kind"].items()) {
        kinds += kind["cycles"].get<std::uint64_t>();
        steps += kind["node_steps"].get<std::uint64_t>();
    }
    CHECK(kinds == sums["cycles"]);
    CHECK(steps == sums["visits"]);
    CHECK(data["kinds"] == report["work_by_kind"]);
}

}   // namespace

TEST_CASE("a report is one file, and its figures are those of the JSON report") {
    for (const bool finished : {false, true}) {
        const TestFolder folder;
        std::vector<std::string> arguments{
            "simulate", finished ? "spheres" : "gears:2", "--size", "40x30", "--clock", "66,200"};
        if (finished) arguments.insert(arguments.end(), {"--depth", "2", "--config", "wide"});
        std::vector<std::string> with = arguments;
        with.insert(with.end(), {"--report", folder.name("a.html"), "--json", folder.name("a.json")});
        const ProgramRun outcome = run_program(with);
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        const std::string page = content_of(folder.name("a.html"));
        const json report = data_of(page, "report");
        CHECK(report == json::parse(content_of(folder.name("a.json"))));
        check_figures(report, data_of(page, "data"));

        arguments.insert(arguments.end(), {"--json", "-"});
        json plain = json::parse(run_program(arguments).out), watched = report;
        CHECK(plain["work_by_kind"].is_null());
        for (const char* kind : {"camera", "shadow", "reflection", "refraction"}) {
            CAPTURE(kind);
            const char* rays = std::string(kind) == "camera" ? "primary" : kind;
            CHECK(report["work_by_kind"][kind]["rays"] == report["rays"][rays]);
        }
        plain.erase("work_by_kind");
        watched.erase("work_by_kind");
        CHECK(lasting(plain) == lasting(watched));

        CHECK(page.size() < 900'000);
        CHECK(count(page, "<html") == 1);
        CHECK(count(page, "data:image/png;base64,") == 3);
        CHECK(count(page, "<table") == count(page, "</table>"));
        CHECK(count(page, "<tr>") > 150);   // tables that need no script
        for (const char* link :
             {"src=\"http", "href=\"http", "url(http", "@import", "<link rel=\"stylesheet"})
            CHECK(page.find(link) == page.npos);
    }
}

TEST_CASE("the maps of a report have what explain says of each pixel, and its slowest are the slowest") {
    constexpr std::size_t width = 40, height = 30;
    const TestFolder folder;
    const std::vector<std::string> scene{"gears:2", "--size", "40x30", "--clock", "66", "--no-judge"};
    const auto with = [&](std::vector<std::string> words, const std::vector<std::string>& more) {
        words.insert(words.end(), scene.begin(), scene.end());
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    REQUIRE(run_program(with({"simulate"}, {"--report", folder.name("a.html")})).code == 0);
    const json data = data_of(content_of(folder.name("a.html")), "data");
    std::map<std::string, std::vector<std::uint32_t>> maps;
    for (const json& map : data["maps"]) maps[map["key"]] = values_of(map, width * height);

    const std::vector<std::size_t> slowest = data["slowest"];
    const std::vector<std::uint32_t>& cycles = maps["cycles"];
    REQUIRE(slowest.size() == 100);
    std::vector<std::uint32_t> sorted = cycles;
    std::sort(sorted.rbegin(), sorted.rend());
    for (std::size_t i = 0; i < slowest.size(); ++i) CHECK(cycles[slowest[i]] == sorted[i]);

    const std::map<std::string, std::string> names{
        {"rays", "rays"},           {"visits", "node_visits"}, {"tests", "primitive_tests"},
        {"misses", "cache_misses"}, {"bytes", "bytes"},        {"first", "first_cycle"},
        {"cycles", "cycles"}};
    for (const std::size_t pixel : {slowest[0], slowest[50], std::size_t(17 * width + 23)}) {
        const std::string place = std::to_string(pixel % width) + "," + std::to_string(pixel / width);
        INFO("pixel " << place);
        const ProgramRun told = run_program(with({"explain"}, {place, "--json", "-"}));
        REQUIRE(told.code == 0);
        const json cost = json::parse(told.out)["cost"];
        for (const auto& [map, figure] : names) {
            INFO(map);
            CHECK(maps[map].at(pixel) == cost[figure]);
        }
    }
}

TEST_CASE("names with markup in them break no page") {
    const TestFolder folder;
    const std::string evil = "<script>alert(1)</script>&\"'";
    const ProgramRun config = run_program({"config", "default"});
    json values = json::parse(config.out);
    values["name"] = evil;
    const std::string file = folder.write("evil<b>.json", values.dump());
    const ProgramRun outcome =
        run_program({"simulate", "gears:1", "--size", "16x12", "--clock", "66", "--config", file,
                     "--no-reference", "--report", folder.name("a.html")});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const std::string page = content_of(folder.name("a.html"));
    CHECK(page.find("<script>alert") == page.npos);
    CHECK(page.find("evil<b>") == page.npos);
    CHECK(page.find("&lt;script&gt;alert(1)&lt;/script&gt;") != page.npos);
    CHECK(data_of(page, "report")["config"]["name"] == evil);
}

TEST_CASE("a report that cannot be made is refused before the work") {
    check_refused(run_program({"simulate", "gears:8", "--report", "/missing/folder/a.html"}),
                  {"/missing/folder/a.html"});
    const TestFolder folder;
    check_refused(run_program({"simulate", "gears:8", "--report", folder.name("a.html")},
                              {"RAYCLOCK_VEGA=" + folder.name("none")}),
                  {"--report", "vega", "libjs-vega"});
    CHECK(folder.contents().empty());
}

TEST_CASE("a browser draws every chart, moves the slider, and says nothing on its console", "[slow]") {
    if (!is_installed("chromium")) {
        WARN("chromium is not installed");
        return;
    }
    for (const char* scene : {"gears:4", "spheres"}) {
        const TestFolder folder;
        REQUIRE(run_program({"simulate", scene, "--size", "128x96", "--clock", "66", "--report",
                             folder.name("a.html")})
                    .code == 0);
        const std::string answer = shown(folder, content_of(folder.name("a.html")), R"(
            const marks = [...document.querySelectorAll('.chart')].map(chart =>
                chart.querySelectorAll('.mark-rect path, .mark-line path, .mark-rule line').length);
            const before = byId('left-canvas').style.clipPath;
            byId('slider').value = 250;
            byId('slider').dispatchEvent(new Event('input'));
            const after = byId('left-canvas').style.clipPath;
            const box = byId('canvases').getBoundingClientRect();
            byId('canvases').dispatchEvent(new PointerEvent('pointermove',
                { clientX: box.left + box.width * 0.501, clientY: box.top + box.height * 0.501 }));
            const cells = [...byId('pixel').querySelectorAll('tr')].map(row => row.cells[1].textContent);
            const pixel = 48 * 128 + 64;
            const right = data.maps.every((map, i) => cells[i + 1] === grouped(map.values[pixel]));
            const image = byId('right-canvas').getContext('2d').getImageData(0, 0, 128, 96).data;
            const colours = new Set();
            for (let i = 0; i < image.length; i += 4) colours.add(image.slice(i, i + 3).join());
            const sums = data.maps.every(map => map.values.reduce((a, b) => a + b, 0) === map.sum);
            return [document.body.dataset.shown, marks.every(n => n > 0), marks.length, before !== after,
                    cells[0], right, colours.size > 10, sums, files['pixels.csv']().split('\n').length,
                    byId('pictures').hidden].join(' ');)");
        CHECK(answer == "yes true 10 true 64, 48 true true true 12290 true");
    }
}
