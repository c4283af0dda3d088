#pragma once
#include <string>

#include "model/base/progress.hpp"

namespace rayclock {

/// docs/yardstick.md: our figures beside published ones, as Markdown. Throws UserError if it is interrupted.
std::string yardstick_page(int threads, const Progress& progress);

}   // namespace rayclock
