#pragma once
// Rounding and unit vectors in fixed point.
#include <algorithm>
#include <array>
#include <cstdint>

#include "model/core/config.hpp"

namespace rayclock {

/// Returns x / 2^drop rounded to nearest, halves up; drop >= 0.
template <class T> constexpr T rounded(T x, int drop) {
    return drop == 0 ? x : (x + (T(1) << (drop - 1))) >> drop;
}

/// Returns the dot product of two unit vectors, with unit_bits fraction bits.
inline std::int64_t unit_dot(const std::array<std::int32_t, 3>& a, const std::array<std::int32_t, 3>& b) {
    return rounded(std::int64_t(a[0]) * b[0] + std::int64_t(a[1]) * b[1] + std::int64_t(a[2]) * b[2],
                   unit_bits);
}
/// Returns that product clamped to 0..1.
inline std::uint32_t clamped_dot(const std::array<std::int32_t, 3>& a, const std::array<std::int32_t, 3>& b) {
    return std::uint32_t(std::clamp<std::int64_t>(unit_dot(a, b), 0, 1 << unit_bits));
}

/// Returns a unit vector as a direction of M bits. No component exceeds 2^(M-2).
inline std::array<std::int32_t, 3> direction_of(const std::array<std::int32_t, 3>& unit, const Config& c) {
    std::array<std::int32_t, 3> d{};
    const int up = c.dir_bits - 2 - unit_bits;
    for (std::size_t k = 0; k < 3; ++k) d[k] = up >= 0 ? unit[k] * (1 << up) : rounded(unit[k], -up);
    return d;
}

}   // namespace rayclock
