// Cutting a polygon into triangles.
//
// Ear clipping on the plane of the polygon's own area vector, so concave polygons come out right. Always
// gives n - 2 triangles with the polygon's winding: where there is no ear (crossing edges, no area) it cuts
// off a corner nevertheless. That is why the importer's own step is not used: it gives up there and loses the
// rest of the face.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace rayclock {

/// Appends index triples into `corners` (at least 3 of them).
void triangulate(std::span<const glm::dvec3> corners, std::vector<std::array<std::uint32_t, 3>>& out);

}   // namespace rayclock
