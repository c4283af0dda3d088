#pragma once
#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace rayclock {

// The sRGB transfer curve, IEC 61966-2-1, for values 0..1.

double srgb_from_linear(double linear);
double linear_from_srgb(double srgb);

/// Clamped to 0..1 (NaN counts as 0), encoded, and rounded to the nearest of 0..255.
std::uint8_t srgb_byte(double linear);
std::array<std::uint8_t, 3> srgb_bytes(const glm::vec3& linear);

}   // namespace rayclock
