// Draws the cost of a frame against its triangles and its pixels.
#include "sim/study/scale/scale_page.hpp"
#include "sim/view/plot/line_chart.hpp"

namespace rayclock::scale {

namespace {

constexpr std::array<plot::Colour, works> colours{{{0x8c, 0x56, 0x4b},
                                                   {0xc8, 0x2a, 0x2a},
                                                   {0xe0, 0x7b, 0x1a},
                                                   {0x2c, 0x8a, 0x3c},
                                                   {0x17, 0x8a, 0x9c},
                                                   {0x1f, 0x5f, 0xa8}}};

/// Returns the panel of one series.
plot::LinePanel panel_of(const std::vector<Row>& rows, std::string title, std::string x_label,
                         double (*size)(const Row&)) {
    plot::LinePanel panel{std::move(title), std::move(x_label), "seconds", {}};
    for (std::size_t w = 0; w < works; ++w) {
        plot::Curve& curve = panel.curves.emplace_back();
        curve.name = work_names[w], curve.colour = colours[w];
        for (const Row& row : rows) curve.points.push_back({size(row), row.seconds[w]});
    }
    return panel;
}

}   // namespace

plot::Drawing picture(const Figures& figures, const Study& study) {
    const std::string first = study.scenes.front();
    return plot::line_chart("The cost of a frame on the host",
                            {panel_of(figures.scenes, first.substr(0, first.find(':')) + ", growing scene",
                                      "triangles", [](const Row& row) { return double(row.triangles); }),
                             panel_of(figures.pictures, first + ", growing picture", "pixels",
                                      [](const Row& row) { return double(row.pixels()); })});
}

}   // namespace rayclock::scale
