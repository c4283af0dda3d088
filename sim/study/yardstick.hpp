#pragma once
#include <string>

#include "model/base/progress.hpp"

namespace rayclock {

/// The clock that `ulx3s` was routed at.
struct RoutedBoard {
    int khz = 0;   ///< 0: it was not
    std::string device;
};
/// docs/yardstick.md: our figures beside published ones, as Markdown. Throws UserError if it is interrupted.
/// Its part on scenes that move: the frames after the first, so many of them.
constexpr int moving_frames = 3;
std::string moving_table(int threads, const Progress& progress);
std::string yardstick_page(const RoutedBoard& board, int threads, const Progress& progress);

}   // namespace rayclock
