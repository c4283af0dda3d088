#pragma once
#include "sim/view/plot/chart.hpp"
#include "sim/explore/sweep/front.hpp"

namespace rayclock::sweep {

/// Error against cost and error against speed, each with its own front, and the knee of the sweep. A single
/// panel, cost against speed, if all errors are equal. Labels are the values of the axes.
plot::Drawing front_plot(const std::string& scene, FrameSize size, const std::vector<Axis>& axes,
                         const std::vector<Result>& results, const Front& front);

/// One column of the table against another, of every point that has both. Throws as column_values().
plot::Drawing column_plot(const std::string& scene, FrameSize size, const std::vector<Axis>& axes,
                          const std::vector<Result>& results, const Front& front, const std::string& x,
                          const std::string& y);

}   // namespace rayclock::sweep
