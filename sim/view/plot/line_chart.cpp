// Places axes, curves and names of line charts.
#include "sim/view/plot/line_chart.hpp"

#include <algorithm>

namespace rayclock::plot {

namespace {

/// Draws a panel whose left edge is at `from`.
class PanelDrawer {
public:
    static constexpr double width = 560, height = 420, left = 64, right = 92, top = 74, bottom = 56;
    static constexpr Colour black{0x22, 0x22, 0x22}, grey{0x66, 0x66, 0x66}, pale{0xe4, 0xe4, 0xe4};

    PanelDrawer(Drawing& drawing, const LinePanel& panel, double from)
        : drawing_(drawing),
          panel_(panel),
          x0_(from + left),
          x1_(from + width - right),
          x_(all(panel, &Curve::Point::x, {}), true),
          y_(all(panel, &Curve::Point::y, panel.y_values), true) {}

    void draw() {
        draw_axes();
        std::vector<std::pair<double, const Curve*>> ends;   // y of each curve's last point
        for (const Curve& curve : panel_.curves) {
            Line line{{}, curve.colour, 2};
            for (const Curve::Point& point : curve.points) line.points.push_back(at(point));
            ends.emplace_back(line.points.back().y, &curve);
            for (const PixelPosition& position : line.points)
                drawing_.shapes.emplace_back(Disc{position, 2.6, curve.colour});
            drawing_.shapes.emplace_back(std::move(line));
        }
        draw_names(std::move(ends));
    }

private:
    static std::vector<double> all(const LinePanel& panel, double Curve::Point::*member,
                                   std::vector<double> values) {
        for (const Curve& curve : panel.curves)
            for (const Curve::Point& point : curve.points) values.push_back(point.*member);
        return values;
    }
    PixelPosition at(const Curve::Point& p) const {
        return {x0_ + x_.place(p.x) * (width - left - right),
                height - bottom - y_.place(p.y) * (height - top - bottom)};
    }

    void draw_axes() {
        for (const Scale::Tick& tick : panel_.x_ticks.empty() ? x_.ticks() : panel_.x_ticks) {
            const double x = at({tick.value, 1}).x;
            drawing_.shapes.emplace_back(Line{{{x, top}, {x, y1}}, pale, 1});
            drawing_.shapes.emplace_back(Text{{x, y1 + 18}, tick.label, 12, grey, Anchor::middle});
        }
        for (const Scale::Tick& tick : y_.ticks()) {
            const double y = at({1, tick.value}).y;
            drawing_.shapes.emplace_back(Line{{{x0_, y}, {x1_, y}}, pale, 1});
            drawing_.shapes.emplace_back(Text{{x0_ - 6, y + 4}, tick.label, 12, grey, Anchor::end});
        }
        drawing_.shapes.emplace_back(Text{{x0_, top - 12}, panel_.title, 14, black});
        drawing_.shapes.emplace_back(
            Text{{(x0_ + x1_) / 2, y1 + 40}, panel_.x_label, 12, grey, Anchor::middle});
        drawing_.shapes.emplace_back(
            Text{{x0_ - left + 16, (top + y1) / 2}, panel_.y_label, 12, grey, Anchor::middle, true});
    }

    /// Draws names at the right ends of the curves, with a minimum distance between them.
    void draw_names(std::vector<std::pair<double, const Curve*>> ends) {
        std::stable_sort(ends.begin(), ends.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        constexpr double apart = 15;
        for (std::size_t i = 1; i < ends.size(); ++i)
            ends[i].first = std::max(ends[i].first, ends[i - 1].first + apart);
        const double over = ends.empty() ? 0 : std::max(0.0, ends.back().first - y1);
        for (const auto& [y, curve] : ends)
            drawing_.shapes.emplace_back(Text{{x1_ + 6, y - over + 4}, curve->name, 12, curve->colour});
    }

    static constexpr double y1 = height - bottom;
    Drawing& drawing_;
    const LinePanel& panel_;
    double x0_, x1_;
    Scale x_, y_;
};

}   // namespace

Drawing line_chart(const std::string& title, const std::vector<LinePanel>& panels) {
    using P = PanelDrawer;
    Drawing drawing{double(panels.size()) * P::width, P::height, {}};
    drawing.shapes.emplace_back(Text{{P::left, 28}, title, 16, P::black});
    double from = 0;
    for (const LinePanel& panel : panels) {
        PanelDrawer(drawing, panel, from).draw();
        from += P::width;
    }
    return drawing;
}

}   // namespace rayclock::plot
