#pragma once
// Exact vector arithmetic of the triangle tests.
#include "model/core/frame.hpp"

namespace rayclock {

/// Exact vectors of lattice points. A difference has N + 1 bits. A component of a cross product has the sum
/// of its factors' bits and one more.
inline Vec3l minus(const Vec3i& a, const Vec3i& b) {
    return {std::int64_t(a[0]) - b[0], std::int64_t(a[1]) - b[1], std::int64_t(a[2]) - b[2]};
}
inline Vec3l cross(const Vec3l& a, const Vec3l& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}   // namespace rayclock
