#pragma once
#include <vector>

#include "sim/load/place.hpp"

namespace rayclock {

/// A polygon with holes as one ring: a bridge, walked in both directions, joins each hole to what is around
/// it. So n corners and h holes have n + 2 h corners in the ring, and n + 2 h - 2 triangles. After D. Eberly,
/// "Triangulation by Ear Clipping". Takes time in proportion to corners times holes. All rings have 3 corners
/// or more. Holes that cross each other or the outline give a ring that crosses itself.
std::vector<Corner> joined_ring(const std::vector<Corner>& outline, std::vector<std::vector<Corner>> holes);

}   // namespace rayclock
