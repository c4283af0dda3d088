// The two branches of the sRGB curve, and its 8-bit rounding.
#include "sim/files/image/srgb.hpp"

#include <algorithm>
#include <cmath>

namespace rayclock {

double srgb_from_linear(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double linear_from_srgb(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

std::uint8_t srgb_byte(double linear) {
    const double clamped = linear > 0 ? std::min(linear, 1.0) : 0.0;   // the comparison is false for NaN
    return static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(clamped)));
}

std::array<std::uint8_t, 3> srgb_bytes(const glm::vec3& linear) {
    return {srgb_byte(linear.r), srgb_byte(linear.g), srgb_byte(linear.b)};
}

}   // namespace rayclock
