// Drawings: well-formed SVG, and ink where it should be.
#include <cmath>

#include "sim/plot/axis.hpp"
#include "tests/sweep/support.hpp"
#include "sim/sweep/plot.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Whether every element is closed in turn, attributes are quoted, and text holds no mark-up.
bool is_well_formed(const std::string& xml) {
    std::vector<std::string> open;
    std::size_t at = 0, elements = 0;
    while (at < xml.size()) {
        if (xml[at] == '>') return false;
        if (xml[at] == '&' && xml.compare(at, 4, "&lt;") && xml.compare(at, 4, "&gt;") && xml.compare(at, 5, "&amp;")) return false;
        if (xml[at] != '<') {
            ++at;
            continue;
        }
        const std::size_t end = xml.find('>', at);
        if (end == std::string::npos) return false;
        const std::string tag = xml.substr(at + 1, end - at - 1);
        if (std::count(tag.begin(), tag.end(), '"') % 2 || tag.find('<') != std::string::npos) return false;
        const std::string name = tag.substr(0, tag.find_first_of(" />", 1));
        if (tag[0] == '/') {
            if (open.empty() || "/" + open.back() != tag) return false;
            open.pop_back();
        } else if (tag.back() != '/') {
            if (open.empty() && elements > 0) return false;
            open.push_back(name);
        }
        ++elements;
        at = end + 1;
    }
    return open.empty() && elements > 0;
}

/// Darkest value in a rectangle of a picture.
float darkest(const Picture& p, int x0, int y0, int x1, int y1) {
    float least = 1;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) least = std::min(least, p.pixels[std::size_t(y * p.size.width + x)].y);
    return least;
}

sweep::Result result(std::uint64_t wrong, double fps, std::uint64_t multipliers) {
    sweep::Result r;
    r.point.values = {std::to_string(wrong)};
    r.clock = {{"cycles", 100.0}, {"fps", fps}};
    r.picture = sweep::PictureFigures{{1000, wrong, 40, 1000, 0.1}, 0, 1000};
    r.multipliers = multipliers;
    return r;
}

} // namespace

TEST_CASE("the check of well-formedness sees faults") {
    CHECK(is_well_formed("<a><b x=\"1\"/>t</a>\n"));
    for (const char* bad : {"", "<a>", "<a></b>", "<a x=\"1></a>", "<a>&</a>", "<a/><b>", "<a>></a>"}) {
        INFO(bad);
        CHECK(!is_well_formed(bad));
    }
}

TEST_CASE("shapes are where they were put, in both forms") {
    plot::Drawing drawing{100, 50, {}};
    drawing.shapes.push_back(plot::Line{{{10, 10}, {40, 10}}, {0, 0, 0}, 2});
    drawing.shapes.push_back(plot::Disc{{70, 25}, 5, {0, 0, 0}});
    drawing.shapes.push_back(plot::Text{{10, 45}, "a < b & c > \"d\"", 12, {0, 0, 0}});
    CHECK(is_well_formed(plot::svg(drawing)));
    CHECK(plot::svg(drawing).find("a &lt; b &amp; c &gt;") != std::string::npos);
    const Picture p = plot::raster(drawing, 2);
    CHECK(p.size.width == 200);
    CHECK(darkest(p, 40, 18, 60, 22) < 0.01f);
    CHECK(darkest(p, 138, 48, 142, 52) < 0.01f);
    CHECK(darkest(p, 20, 68, 190, 92) < 0.2f);   // the text
    CHECK(darkest(p, 100, 0, 200, 30) == 1);     // nothing
}

TEST_CASE("every letter has ink of its own, within its width") {
    std::vector<std::vector<float>> seen;
    for (char c = '!'; c <= '~'; ++c) {
        INFO("letter " << c);
        plot::Drawing drawing{40, 40, {}};
        drawing.shapes.push_back(plot::Text{{8, 28}, std::string(1, c), 24, {0, 0, 0}});
        const Picture p = plot::raster(drawing, 1);
        std::vector<float> ink;
        for (const glm::vec3& v : p.pixels) ink.push_back(v.x);
        CHECK(*std::min_element(ink.begin(), ink.end()) < 0.5f);
        CHECK(std::find(seen.begin(), seen.end(), ink) == seen.end());
        seen.push_back(ink);
        const int end = int(8 + plot::text_width(std::string(1, c), 24) + plot::pen_width(24)) + 2;
        CHECK(darkest(p, std::min(end, 39), 0, 40, 40) == 1);
        CHECK(darkest(p, 0, 0, 5, 40) == 1);
    }
}

TEST_CASE("scales have ticks inside, and a place for zero") {
    for (const bool logarithmic : {false, true})
        for (const std::vector<double>& values : std::vector<std::vector<double>>{{1, 2, 3}, {0.001, 1000}, {5}, {7, 7}, {0, 0.5, 20}, {0}, {}, {1e9, 2e9}}) {
            const plot::Scale scale(values, logarithmic);
            for (const double v : values) {
                CHECK(scale.place(v) > 0);
                CHECK(scale.place(v) < 1);
            }
            CHECK(!scale.ticks().empty());
            for (const auto& tick : scale.ticks()) {
                INFO(tick.label);
                CHECK(scale.place(tick.value) >= 0);
                CHECK(scale.place(tick.value) <= 1);
            }
        }
    const plot::Scale log({0, 0.01, 1}, true);
    CHECK(log.place(0) < log.place(0.01));
}

TEST_CASE("a plot of a front names the knee and is well formed") {
    const std::vector<sweep::Result> results{result(500, 50, 90), result(40, 49, 100), result(5, 48, 160), result(0, 47, 300), {}};
    const sweep::Front front = sweep::front_of(results);
    REQUIRE(front.knee);
    const plot::Drawing drawing = sweep::front_plot("a<b>", {40, 25}, {{"coord_bits", {}}}, results, front);
    const std::string svg = plot::svg(drawing);
    CHECK(is_well_formed(svg));
    for (const char* word : {"a&lt;b&gt;, 40x25 pixels", "the knee, coord_bits 40", "pixels with another primitive, %", "multipliers, 18x18 bits", "frames per second"}) {
        INFO(word);
        CHECK(svg.find(word) != std::string::npos);
    }
    CHECK(darkest(plot::raster(drawing, 1), 0, 0, int(drawing.width), int(drawing.height)) < 0.1f);
    for (const std::size_t count : {0, 1}) {   // nothing to see is no reason to fail
        const std::vector<sweep::Result> few(results.begin(), results.begin() + std::ptrdiff_t(count));
        CHECK(is_well_formed(plot::svg(sweep::front_plot("s", {4, 4}, {{"coord_bits", {}}}, few, sweep::front_of(few)))));
    }
}
