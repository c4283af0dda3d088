#pragma once
// Panels of points, for fronts: which configurations are worth having, and which is the knee.
#include "sim/view/plot/drawing.hpp"

namespace rayclock::plot {

struct Mark {
    double x = 0, y = 0;
    std::string label;
    bool on_front = false;
    bool is_knee = false;
};

struct Panel {
    std::string title, x_label, y_label;   ///< labels with their units
    bool log_y = false;                    ///< 0 gets a place of its own below
    std::vector<Mark> marks;
};

/// Panels side by side. Points of the front are dark and joined by a line, all others pale; the knee has a
/// ring. Points of a front are always labelled if there is room at all, others if nothing is covered by it.
Drawing chart(const std::string& title, const std::string& note, const std::vector<Panel>& panels);

}   // namespace rayclock::plot
