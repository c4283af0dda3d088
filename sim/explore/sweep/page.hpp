#pragma once
// A sweep as one HTML file that needs no network: its points in linked charts, and as a table.
#include "sim/explore/sweep/front.hpp"
#include "sim/explore/sweep/merge.hpp"

namespace rayclock::sweep {

/// `far`: far_points(); `origin`: command line and versions. Throws UserError if the library that draws the
/// charts is not installed.
std::string sweep_page(const Merged& swept, const Front& front, const std::string& far,
                       const std::vector<std::pair<std::string, std::string>>& origin);

}   // namespace rayclock::sweep
