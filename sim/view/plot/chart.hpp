#pragma once
// Panels of points for Pareto fronts, with the front and its knee marked.
#include "sim/view/plot/drawing.hpp"

namespace rayclock::plot {

/// A point with its label.
struct Mark {
    double x = 0, y = 0;
    std::string label;
    bool on_front = false;
    bool is_knee = false;
};

/// One diagram with two axes.
struct Panel {
    std::string title, x_label, y_label;   ///< axis labels include units
    bool log_y = false;                    ///< logarithmic, with 0 below the other values
    std::vector<Mark> marks;
};

/// Draws panels side by side. Points of the front are dark and joined by a line, all others pale; the knee
/// has a ring. The knee gets its label first, then the other points of the front, then the rest. A label that
/// would cover something is omitted, except the knee's.
Drawing chart(const std::string& title, const std::string& note, const std::vector<Panel>& panels);

}   // namespace rayclock::plot
