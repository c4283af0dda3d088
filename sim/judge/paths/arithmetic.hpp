#pragma once
// Arithmetic of the judge: integers of 128 bits for exact values, ranges of doubles for values with an error
// bound.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "sim/judge/oracle/solids.hpp"

namespace rayclock {

using oracle::Int128;

/// Return a / b rounded down and up, b > 0.
constexpr Int128 floor_of(Int128 a, Int128 b) { return a / b - (a % b < 0 ? 1 : 0); }
constexpr Int128 ceil_of(Int128 a, Int128 b) { return -floor_of(-a, b); }
/// Returns a / b rounded to nearest, halves up.
constexpr Int128 nearest_of(Int128 a, Int128 b) { return floor_of(2 * a + b, 2 * b); }
/// The same for b = 2^bits.
constexpr Int128 nearest_of_power(Int128 a, int bits) { return nearest_of(a, Int128(1) << bits); }

/// Holds a value with known bounds. Doubles round by 2^-53 of a value; `slack` covers all roundings of the
/// computation of a colour.
struct Range {
    double lo = 0, hi = 0;
    static constexpr double slack = 0x1p-40;

    static Range around(double value, double error) { return {value - error, value + error}; }
    double middle() const { return 0.5 * (lo + hi); }
    Range wider(double error) const { return {lo - error, hi + error}; }
    Range clamped(double least, double most) const {
        return {std::clamp(lo, least, most), std::clamp(hi, least, most)};
    }
    bool holds(double value) const { return value >= lo - slack && value <= hi + slack; }
    friend Range operator+(const Range& a, const Range& b) { return {a.lo + b.lo, a.hi + b.hi}; }
    friend Range operator-(const Range& a, const Range& b) { return {a.lo - b.hi, a.hi - b.lo}; }
    friend Range operator*(const Range& a, const Range& b) {
        const double p[4] = {a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
        return {std::min({p[0], p[1], p[2], p[3]}), std::max({p[0], p[1], p[2], p[3]})};
    }
    friend Range operator*(double a, const Range& b) {
        return a >= 0 ? Range{a * b.lo, a * b.hi} : Range{a * b.hi, a * b.lo};
    }
};

template <class A, class B> Int128 dot(const std::array<A, 3>& a, const std::array<B, 3>& b) {
    return Int128(a[0]) * b[0] + Int128(a[1]) * b[1] + Int128(a[2]) * b[2];
}
inline glm::dvec3 vector_of(const Vec3i& v) { return {v[0], v[1], v[2]}; }
inline glm::dvec3 vector_of(const Vec3l& v) { return {double(v[0]), double(v[1]), double(v[2])}; }

/// Step of colours, weights and components of unit vectors.
constexpr double unit_step = 1.0 / (1 << unit_bits);
/// Error of unit_vector(), proven in model/fixed/unit_vector.hpp.
constexpr double component_error = 3.2 * unit_step;
constexpr double vector_error = 1.7320509 * component_error;
/// Error of the clamped and rounded product of two unit vectors, each of which is off by vector_error.
constexpr double cosine_error = 2 * vector_error + vector_error * vector_error + 0.5 * unit_step;

}   // namespace rayclock
