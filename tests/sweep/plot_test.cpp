// Plots: well-formed SVG, correct positions of shapes, and labels that cover nothing.
#include <cmath>

#include "sim/view/plot/axis.hpp"
#include "tests/sweep/small_sweeps.hpp"
#include "sim/explore/sweep/plot.hpp"

namespace rayclock::test::plot_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Returns true if elements are closed in order, attributes are quoted, and text has no mark-up.
bool is_well_formed(const std::string& xml) {
    std::vector<std::string> open;
    std::size_t at = 0, elements = 0;
    while (at < xml.size()) {
        if (xml[at] == '>') return false;
        if (xml[at] == '&' && xml.compare(at, 4, "&lt;") && xml.compare(at, 4, "&gt;") &&
            xml.compare(at, 5, "&amp;"))
            return false;
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

struct Box {
    double x0, y0, x1, y1;
    bool meets(const Box& b) const { return x0 < b.x1 && b.x0 < x1 && y0 < b.y1 && b.y0 < y1; }
};
/// Returns the boxes of labels, which are texts of this size.
std::vector<Box> labels_of(const plot::Drawing& drawing, double size) {
    std::vector<Box> boxes;
    for (const plot::Shape& shape : drawing.shapes)
        if (const auto* t = std::get_if<plot::Text>(&shape); t && t->size == size)
            boxes.push_back(
                {t->base.x, t->base.y - 0.72 * size, t->base.x + plot::text_width(t->text, size), t->base.y});
    return boxes;
}

sweep::Result result(std::uint64_t wrong, double fps, std::uint64_t multipliers) {
    sweep::Result r;
    r.point.values = {std::to_string(wrong)};
    r.clock = {{"cycles", 100.0}, {"fps", fps}, {"frames", {nullptr}}};
    r.picture = sweep::PictureFigures{{1000, wrong, 40, 1000, 0.1}, 0, 1000, {}};
    r.multipliers = multipliers;
    return r;
}

}   // namespace

TEST_CASE("the check of well-formedness sees faults") {
    CHECK(is_well_formed("<a><b x=\"1\"/>t</a>\n"));
    for (const char* bad : {"", "<a>", "<a></b>", "<a x=\"1></a>", "<a>&</a>", "<a/><b>", "<a>></a>"}) {
        INFO(bad);
        CHECK(!is_well_formed(bad));
    }
}

TEST_CASE("shapes are where they were put") {
    plot::Drawing drawing{100, 50, {}};
    drawing.shapes.emplace_back(plot::Line{{{10, 10}, {40, 10}}, {0, 0, 0}, 2});
    drawing.shapes.emplace_back(plot::Disc{{70, 25}, 5, {255, 0, 0}});
    drawing.shapes.emplace_back(plot::Text{{10, 45}, "a < b & c > \"d\"", 12, {0, 0, 0}});
    const std::string svg = plot::svg(drawing);
    CHECK(is_well_formed(svg));
    for (const char* part : {"width=\"100\" height=\"50\"", "points=\"10.00,10.00 40.00,10.00\"",
                             "<circle cx=\"70.00\" cy=\"25.00\" r=\"5.00\" fill=\"#ff0000\"",
                             "<text x=\"10.00\" y=\"45.00\"", ">a &lt; b &amp; c &gt; \"d\"</text>"}) {
        INFO(part);
        CHECK(svg.find(part) != std::string::npos);
    }
}

TEST_CASE("a text is as wide as its letters and the gaps between them") {
    CHECK(plot::text_width("", 12) == 0);
    for (char c = ' '; c <= '~'; ++c) {
        INFO("letter " << c);
        const std::string one(1, c);
        const double width = plot::text_width(one, 12), gap = plot::text_width(one + one, 12) - 2 * width;
        CHECK(width >= 0);
        CHECK(gap > 1);
        CHECK(plot::text_width(one + "x" + one, 24) ==
              Approx(2 * (2 * width + plot::text_width("x", 12) + 2 * gap)));
    }
    CHECK(plot::text_width("i", 12) < plot::text_width("n", 12));
    CHECK(plot::text_width("\x01", 12) == plot::text_width("?", 12));
}

TEST_CASE("labels cover neither points nor one another") {
    plot::Panel panel{"", "x", "y", false, {}};
    for (int i = 0; i < 40; ++i)
        panel.marks.push_back(
            {double(i % 8), double(i * i % 11), "12 / " + std::to_string(i), i % 3 == 0, false});
    const plot::Drawing drawing = plot::chart("", "", {panel});
    const std::vector<Box> labels = labels_of(drawing, 11.5);
    CHECK(labels.size() > 10);
    CHECK(labels.size() < 40);   // there is not room for all
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) CHECK(!labels[i].meets(labels[k]));
        for (const plot::Shape& shape : drawing.shapes)
            if (const auto* d = std::get_if<plot::Disc>(&shape))
                CHECK(!labels[i].meets({d->centre.x - d->radius, d->centre.y - d->radius,
                                        d->centre.x + d->radius, d->centre.y + d->radius}));
    }
}

TEST_CASE("title and note of a chart are never cut off, and cover no panel") {
    plot::Panel panel{"speed against cost", "x", "y", false, {{1, 1, "", false, false}}};
    const std::string word = "configurations ";
    for (const std::size_t words : {1, 8, 40}) {
        std::string text;
        for (std::size_t i = 0; i < words; ++i) text += word;
        text.pop_back();
        const plot::Drawing drawing = plot::chart(text, text, {panel});
        std::size_t seen = 0;
        double lowest = 0, panel_title = 0;
        for (const plot::Shape& shape : drawing.shapes) {
            const auto* t = std::get_if<plot::Text>(&shape);
            if (!t) continue;
            if (t->text == panel.title) panel_title = t->base.y;
            if (t->text.find("config") != 0) continue;
            CHECK(t->base.x + plot::text_width(t->text, t->size) <= drawing.width);
            seen += std::size_t(std::count(t->text.begin(), t->text.end(), 'f'));
            lowest = std::max(lowest, t->base.y);
        }
        CHECK(seen == 2 * words);
        CHECK(lowest + 8 < panel_title - 14);
        CHECK(panel_title < drawing.height - 300);
    }
}

TEST_CASE("scales have ticks inside, and a place for zero") {
    for (const bool logarithmic : {false, true})
        for (const std::vector<double>& values : std::vector<std::vector<double>>{
                 {1, 2, 3}, {0.001, 1000}, {5}, {7, 7}, {0, 0.5, 20}, {0}, {}, {1e9, 2e9}}) {
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
    const std::vector<sweep::Result> results{
        result(500, 50, 90), result(40, 49, 100), result(5, 48, 160), result(0, 47, 300), {}};
    const sweep::Front front = sweep::front_of(results);
    REQUIRE(front.knee);
    const plot::Drawing drawing = sweep::front_plot("a<b>", {40, 25}, {{"coord_bits", {}}}, results, front);
    const std::string svg = plot::svg(drawing);
    CHECK(is_well_formed(svg));
    for (const char* word :
         {"a&lt;b&gt;, 40x25 pixels", "the knee, coord_bits 40", "pixels with another primitive, %",
          "multipliers, 18x18 bits", "frames per second"}) {
        INFO(word);
        CHECK(svg.find(word) != std::string::npos);
    }
    // Any two columns, without a front.
    const std::vector<sweep::Axis> axes{{"coord_bits", {"500", "40", "5", "0"}}};
    const std::string columns =
        plot::svg(sweep::column_plot("s", {40, 25}, axes, {}, {}, "coord_bits", "cycles"));
    CHECK(is_well_formed(columns));
    CHECK(columns.find("cycles against coord_bits") != std::string::npos);
    for (const std::size_t count : {0, 1}) {   // an empty plot is not an error
        const std::vector<sweep::Result> few(results.begin(), results.begin() + std::ptrdiff_t(count));
        CHECK(is_well_formed(
            plot::svg(sweep::front_plot("s", {4, 4}, {{"coord_bits", {}}}, few, sweep::front_of(few)))));
    }
}

}   // namespace rayclock::test::plot_test
