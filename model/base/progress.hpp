#pragma once
// The callback by which long work reports its progress.
#include <cstdint>
#include <functional>
#include <string_view>

namespace rayclock {

/// Reports the progress of long work: its name, the units done, and the total. One thread calls it at a time,
/// possibly often. The receiver decides how often to draw.
using Progress = std::function<void(std::string_view what, std::uint64_t done, std::uint64_t total)>;

}   // namespace rayclock
