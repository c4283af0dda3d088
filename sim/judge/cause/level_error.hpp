#pragma once
// Bounds on the level of a texture that the machine draws. guide_texture.cpp computes them.
#include <array>
#include <cstdint>

namespace rayclock {

/// The largest error of the machine's level, apart from an instance's map (docs/machine/shading.md, Bound of
/// the level).
constexpr double error_of_level = 0.25;

/// An instance's map scales lengths in a plane by one factor, and the volume by another. Returns the largest
/// difference between the logarithm of the first and a third of the logarithm of the second: 0 if the map
/// preserves angles.
double stretch_error(const std::array<std::int64_t, 9>& a);

}   // namespace rayclock
