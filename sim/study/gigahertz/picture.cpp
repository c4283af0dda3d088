// Draws frames per second against the clock.
#include <algorithm>

#include <fmt/format.h>

#include "sim/study/gigahertz/page.hpp"
#include "sim/view/plot/axis.hpp"

namespace rayclock::gigahertz {

namespace {

using plot::Anchor;
using plot::Colour;
using plot::Drawing;
using plot::PixelPosition;

constexpr double width = 560, height = 420, left = 64, right = 92, top = 74, bottom = 56;
constexpr Colour black{0x22, 0x22, 0x22}, grey{0x66, 0x66, 0x66}, pale{0xe4, 0xe4, 0xe4};
constexpr Colour colours[]{{0x8c, 0x56, 0x4b}, {0xc8, 0x2a, 0x2a}, {0xe0, 0x7b, 0x1a}, {0x9a, 0x86, 0x0c},
                           {0x2c, 0x8a, 0x3c}, {0x17, 0x8a, 0x9c}, {0x1f, 0x5f, 0xa8}, {0x44, 0x44, 0x44}};

struct Axes {
    plot::Scale x, y;
    double from;   // left edge of the panel
    PixelPosition at(double mhz, double fps) const {
        return {from + left + x.place(mhz) * (width - left - right),
                height - bottom - y.place(fps) * (height - top - bottom)};
    }
};

void draw_frame(Drawing& drawing, const Axes& axes, const std::string& title) {
    const double x0 = axes.from + left, x1 = axes.from + width - right, y0 = top, y1 = height - bottom;
    for (const int mhz : clocks()) {
        const double x = axes.at(mhz, 1).x;
        drawing.shapes.emplace_back(plot::Line{{{x, y0}, {x, y1}}, pale, 1});
        drawing.shapes.emplace_back(plot::Text{{x, y1 + 18}, std::to_string(mhz), 12, grey, Anchor::middle});
    }
    for (const plot::Scale::Tick& tick : axes.y.ticks()) {
        const double y = axes.at(1, tick.value).y;
        drawing.shapes.emplace_back(plot::Line{{{x0, y}, {x1, y}}, pale, 1});
        drawing.shapes.emplace_back(plot::Text{{x0 - 6, y + 4}, tick.label, 12, grey, Anchor::end});
    }
    drawing.shapes.emplace_back(plot::Text{{x0, top - 12}, title, 14, black});
    drawing.shapes.emplace_back(
        plot::Text{{(x0 + x1) / 2, y1 + 40}, "clock, MHz (assumed)", 12, grey, Anchor::middle});
    drawing.shapes.emplace_back(
        plot::Text{{axes.from + 16, (y0 + y1) / 2}, "frames per second", 12, grey, Anchor::middle, true});
}

/// Draws names at the right ends of the lines, with a minimum distance between them.
void draw_names(Drawing& drawing, std::vector<std::pair<double, std::size_t>> ends, double x) {
    std::sort(ends.begin(), ends.end());
    constexpr double apart = 15;
    for (std::size_t i = 1; i < ends.size(); ++i)
        ends[i].first = std::max(ends[i].first, ends[i - 1].first + apart);
    const double over = ends.empty() ? 0 : std::max(0.0, ends.back().first - (height - bottom));
    for (const auto& [y, m] : ends)
        drawing.shapes.emplace_back(plot::Text{{x, y - over + 4}, memories()[m].name, 12, colours[m]});
}

}   // namespace

plot::Drawing picture(const Figures& figures, const Study& study) {
    static_assert(std::size(colours) == 8, "a colour for each memory");
    std::vector<double> mhz(clocks().begin(), clocks().end()), fps;
    for (const auto& [point, frame] : figures.camera) fps.push_back(frame.fps);
    Drawing drawing{2 * width, height, {}};
    drawing.shapes.emplace_back(plot::Text{{left, 28},
                                           fmt::format("{}, {}x{}, camera rays: what the clock alone brings",
                                                       study.scene, study.size.width, study.size.height),
                                           16,
                                           black});
    double from = 0;
    for (const int p : {pipelines().front(), pipelines().back()}) {
        const Axes axes{plot::Scale(mhz, true), plot::Scale(fps, true), from};
        draw_frame(drawing, axes, fmt::format("{} pipeline{}", p, p == 1 ? "" : "s"));
        std::vector<std::pair<double, std::size_t>> ends;
        for (std::size_t m = 0; m < memories().size(); ++m) {
            plot::Line line{{}, colours[m], 2};
            for (const int clock : clocks())
                line.points.push_back(axes.at(clock, figures.at(m, clock, p).fps));
            ends.emplace_back(line.points.back().y, m);
            for (const PixelPosition& place : line.points)
                drawing.shapes.emplace_back(plot::Disc{place, 2.6, colours[m]});
            drawing.shapes.emplace_back(std::move(line));
        }
        draw_names(drawing, std::move(ends), from + width - right + 6);
        from += width;
    }
    return drawing;
}

}   // namespace rayclock::gigahertz
