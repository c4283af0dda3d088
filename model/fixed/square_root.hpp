#pragma once
// The integer square root of the unit shade and of spheres.
#include <cstdint>

namespace rayclock {

__extension__ using Unsigned = unsigned __int128;

/// Returns floor(sqrt(x)). Mirror of rtl/fixed/rc_sqrt.sv.
std::uint64_t square_root(Unsigned x);

}   // namespace rayclock
