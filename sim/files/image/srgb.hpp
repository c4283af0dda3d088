#pragma once
// The sRGB transfer curve, IEC 61966-2-1, for values from 0 to 1.
#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace rayclock {

double srgb_from_linear(double linear);
double linear_from_srgb(double srgb);

/// Clamps to 0..1 (NaN counts as 0), encodes, and rounds to the nearest integer in 0..255.
std::uint8_t srgb_byte(double linear);
std::array<std::uint8_t, 3> srgb_bytes(const glm::vec3& linear);

}   // namespace rayclock
