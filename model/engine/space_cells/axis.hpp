#pragma once
// The axis of a plane in a node.
#include <cstdint>

namespace rayclock {

constexpr std::uint32_t no_axis = 3;   ///< axis of a missing plane

}   // namespace rayclock
