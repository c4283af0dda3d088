#pragma once
#include <cstdint>
#include <functional>
#include <string_view>

namespace rayclock {

/// Told about long work: what is being done, how much of it, out of how much. Called from one thread
/// at a time, possibly often; whoever draws it decides how often to draw.
using Progress = std::function<void(std::string_view what, std::uint64_t done, std::uint64_t total)>;

}   // namespace rayclock
