#pragma once
// The Bezier patches of the teapot.
#include <array>
#include <vector>

#include <glm/vec3.hpp>

namespace rayclock {

/// Sixteen control points of a bicubic Bezier patch, row by row.
using TeapotPatch = std::array<glm::dvec3, 16>;

/// Returns the 32 patches of Martin Newell's teapot of 1975, as in Haines' package: rim and body,
/// handle, spout, lid, bottom.
std::vector<TeapotPatch> teapot_patches();

}   // namespace rayclock
