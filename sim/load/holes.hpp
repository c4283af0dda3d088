#pragma once
// Polygons with holes, joined into one ring.
#include <vector>

#include "sim/load/part_builder.hpp"

namespace rayclock {

/// Returns a polygon with holes as one ring. A bridge, which is walked in both directions, joins each hole to
/// the ring around it. So n corners and h holes give n + 2 h corners in the ring and n + 2 h - 2 triangles.
/// All rings must have at least 3 corners. Holes that cross each other or the outline give a ring that
/// crosses itself.
///
/// After D. Eberly, "Triangulation by Ear Clipping". Takes O(corners * holes) time.
std::vector<Corner> joined_ring(const std::vector<Corner>& outline, std::vector<std::vector<Corner>> holes);

}   // namespace rayclock
