#pragma once
// The page that compares this machine with SaarCOR, RPU and Vortex.
#include <string>

#include "model/base/progress.hpp"

namespace rayclock {

/// The clock that `ulx3s` was routed at.
struct RoutedBoard {
    int khz = 0;   ///< 0 if it was not routed
    std::string device;
};
/// The number of frames after the first in the section on scenes that move.
constexpr int moving_frames = 3;
/// Returns the table of scenes that move. Throws Interrupted after Ctrl-C.
std::string moving_table(int threads, const Progress& progress);
/// Returns docs/measured/comparison-with-other-chips.md as Markdown: simulated figures next to published
/// ones. Throws Interrupted after Ctrl-C.
std::string yardstick_page(const RoutedBoard& board, int threads, const Progress& progress);

}   // namespace rayclock
