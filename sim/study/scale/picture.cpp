// Draws the cost of a frame against its triangles and its pixels.
#include <algorithm>

#include "sim/study/scale/page.hpp"
#include "sim/view/plot/axis.hpp"

namespace rayclock::scale {

namespace {

using plot::Anchor;
using plot::Colour;
using plot::Drawing;
using plot::PixelPosition;

constexpr double width = 560, height = 420, left = 64, right = 92, top = 74, bottom = 56;
constexpr Colour black{0x22, 0x22, 0x22}, grey{0x66, 0x66, 0x66}, pale{0xe4, 0xe4, 0xe4};
constexpr std::array<Colour, works> colours{{{0x8c, 0x56, 0x4b},
                                             {0xc8, 0x2a, 0x2a},
                                             {0xe0, 0x7b, 0x1a},
                                             {0x2c, 0x8a, 0x3c},
                                             {0x17, 0x8a, 0x9c},
                                             {0x1f, 0x5f, 0xa8}}};

/// A diagram of one series.
struct Diagram {
    const std::vector<Row>& rows;
    double (*size)(const Row&);
    std::string title, label;
    double from = 0;   ///< left edge
};

std::vector<double> sizes_of(const Diagram& d) {
    std::vector<double> sizes;
    for (const Row& row : d.rows) sizes.push_back(d.size(row));
    return sizes;
}

std::vector<double> times_of(const Diagram& d) {
    std::vector<double> times;
    for (const Row& row : d.rows) times.insert(times.end(), row.seconds.begin(), row.seconds.end());
    return times;
}

void draw(Drawing& drawing, const Diagram& d) {
    const plot::Scale across(sizes_of(d), true), up(times_of(d), true);
    const double x0 = d.from + left, x1 = d.from + width - right, y0 = top, y1 = height - bottom;
    const auto at = [&](double size, double seconds) {
        return PixelPosition{x0 + across.place(size) * (x1 - x0), y1 - up.place(seconds) * (y1 - y0)};
    };
    for (const plot::Scale::Tick& tick : across.ticks()) {
        const double x = at(tick.value, 1).x;
        drawing.shapes.emplace_back(plot::Line{{{x, y0}, {x, y1}}, pale, 1});
        drawing.shapes.emplace_back(plot::Text{{x, y1 + 18}, tick.label, 12, grey, Anchor::middle});
    }
    for (const plot::Scale::Tick& tick : up.ticks()) {
        const double y = at(1, tick.value).y;
        drawing.shapes.emplace_back(plot::Line{{{x0, y}, {x1, y}}, pale, 1});
        drawing.shapes.emplace_back(plot::Text{{x0 - 6, y + 4}, tick.label, 12, grey, Anchor::end});
    }
    drawing.shapes.emplace_back(plot::Text{{x0, top - 12}, d.title, 14, black});
    drawing.shapes.emplace_back(plot::Text{{(x0 + x1) / 2, y1 + 40}, d.label, 12, grey, Anchor::middle});
    drawing.shapes.emplace_back(
        plot::Text{{d.from + 16, (y0 + y1) / 2}, "seconds", 12, grey, Anchor::middle, true});

    std::vector<std::pair<double, std::size_t>> ends;   // y of each line's last point, and its work
    for (std::size_t w = 0; w < works; ++w) {
        plot::Line line{{}, colours[w], 2};
        for (const Row& row : d.rows) line.points.push_back(at(d.size(row), row.seconds[w]));
        ends.emplace_back(line.points.back().y, w);
        for (const PixelPosition& point : line.points)
            drawing.shapes.emplace_back(plot::Disc{point, 2.6, colours[w]});
        drawing.shapes.emplace_back(std::move(line));
    }
    std::sort(ends.begin(), ends.end());
    constexpr double apart = 15;   // least distance between two names
    for (std::size_t i = 1; i < ends.size(); ++i)
        ends[i].first = std::max(ends[i].first, ends[i - 1].first + apart);
    const double over = std::max(0.0, ends.back().first - y1);
    for (const auto& [y, w] : ends)
        drawing.shapes.emplace_back(plot::Text{{x1 + 6, y - over + 4}, work_names[w], 12, colours[w]});
}

}   // namespace

plot::Drawing picture(const Figures& figures, const Study& study) {
    Drawing drawing{2 * width, height, {}};
    drawing.shapes.emplace_back(plot::Text{{left, 28}, "The cost of a frame on the host", 16, black});
    draw(drawing, {figures.scenes, [](const Row& row) { return double(row.triangles); },
                   study.scenes.front().substr(0, study.scenes.front().find(':')) + ", growing scene",
                   "triangles", 0});
    draw(drawing, {figures.pictures, [](const Row& row) { return double(row.pixels()); },
                   study.scenes.front() + ", growing picture", "pixels", width});
    return drawing;
}

}   // namespace rayclock::scale
