#pragma once
// Panels of lines on logarithmic axes.
#include "sim/view/plot/axis.hpp"
#include "sim/view/plot/drawing.hpp"

namespace rayclock::plot {

/// A line through points, with its name at the right end.
struct Curve {
    struct Point {
        double x = 0, y = 0;
    };
    std::string name;
    Colour colour{};
    std::vector<Point> points;   ///< at least one
};

/// One diagram with two logarithmic axes.
struct LinePanel {
    std::string title, x_label, y_label;   ///< axis labels include units
    std::vector<Curve> curves;
    /// Ticks of the x axis. Without any, the scale chooses them.
    std::vector<Scale::Tick> x_ticks{};
    /// More values that the y axis covers, so that several panels have the same axis.
    std::vector<double> y_values{};
};

/// Draws panels side by side.
Drawing line_chart(const std::string& title, const std::vector<LinePanel>& panels);

}   // namespace rayclock::plot
