// Draws frames per second against the clock.
#include <fmt/format.h>

#include "sim/study/gigahertz/gigahertz_page.hpp"
#include "sim/view/plot/line_chart.hpp"

namespace rayclock::gigahertz {

namespace {

constexpr plot::Colour colours[]{{0x8c, 0x56, 0x4b}, {0xc8, 0x2a, 0x2a}, {0xe0, 0x7b, 0x1a},
                                 {0x9a, 0x86, 0x0c}, {0x2c, 0x8a, 0x3c}, {0x17, 0x8a, 0x9c},
                                 {0x1f, 0x5f, 0xa8}, {0x44, 0x44, 0x44}};

}   // namespace

plot::Drawing picture(const Figures& figures, const Study& study) {
    static_assert(std::size(colours) == 8, "a colour for each memory");
    std::vector<plot::Scale::Tick> ticks;
    for (const int mhz : clocks()) ticks.push_back({double(mhz), std::to_string(mhz)});
    std::vector<double> fps;
    for (const auto& [point, frame] : figures.camera) fps.push_back(frame.fps);
    std::vector<plot::LinePanel> panels;
    for (const int p : {pipelines().front(), pipelines().back()}) {
        plot::LinePanel& panel = panels.emplace_back();
        panel.title = fmt::format("{} pipeline{}", p, p == 1 ? "" : "s");
        panel.x_label = "clock, MHz (assumed)", panel.y_label = "frames per second";
        panel.x_ticks = ticks, panel.y_values = fps;
        for (std::size_t m = 0; m < memories().size(); ++m) {
            plot::Curve& curve = panel.curves.emplace_back();
            curve.name = memories()[m].name, curve.colour = colours[m];
            for (const int mhz : clocks()) curve.points.push_back({double(mhz), figures.at(m, mhz, p).fps});
        }
    }
    return plot::line_chart(fmt::format("{}, {}x{}, camera rays: what the clock alone brings", study.scene,
                                        study.size.width, study.size.height),
                            panels);
}

}   // namespace rayclock::gigahertz
