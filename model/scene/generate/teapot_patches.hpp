#pragma once
#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace rayclock {

/// Sixteen control points of a bicubic Bezier patch, row by row, as indices into teapot_points.
using TeapotPatch = std::array<std::uint16_t, 16>;

extern const std::array<glm::dvec3, 290> teapot_points;
extern const std::array<TeapotPatch, 32> teapot_patches;

}   // namespace rayclock
