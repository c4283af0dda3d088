#pragma once
// A sweep as one HTML file that needs no network: linked charts of its points, and a table.
#include "sim/explore/sweep/front.hpp"
#include "sim/explore/sweep/merge.hpp"

namespace rayclock::sweep {

/// Returns the page. `far` is the result of far_points(), `origin` the command line and versions. Throws
/// UserError if the chart library is not installed.
std::string sweep_page(const MergedSweep& swept, const Front& front, const std::string& far,
                       const std::vector<std::pair<std::string, std::string>>& origin);

}   // namespace rayclock::sweep
