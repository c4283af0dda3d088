#pragma once
// Diagrams of a sweep.
#include "sim/explore/sweep/front.hpp"
#include "sim/view/plot/chart.hpp"

namespace rayclock::sweep {

/// Draws error against cost and error against speed, each with its own front, and the sweep's knee. If all
/// errors are equal, draws a single panel of cost against speed. Labels are the values of the axes.
plot::Drawing front_plot(const std::string& scene, FrameSize size, const std::vector<Axis>& axes,
                         const std::vector<Result>& results, const Front& front);

/// Draws one column of the table against another, for every point that has both. Throws like column_values().
plot::Drawing column_plot(const std::string& scene, FrameSize size, const std::vector<Axis>& axes,
                          const std::vector<Result>& results, const Front& front, const std::string& x,
                          const std::string& y);

}   // namespace rayclock::sweep
