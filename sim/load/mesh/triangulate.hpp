#pragma once
// Cuts a polygon into triangles by ear clipping, in the plane of the polygon's own area vector. So it cuts
// concave polygons correctly.
//
// It always yields n - 2 triangles with the polygon's winding. Where no ear exists (crossing edges, no area),
// it cuts off a corner nevertheless. Other importers stop there and lose the rest of the face.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace rayclock {

/// Appends triples of indices into `corners`, which has at least 3 entries.
void triangulate(std::span<const glm::dvec3> corners, std::vector<std::array<std::uint32_t, 3>>& out);

}   // namespace rayclock
