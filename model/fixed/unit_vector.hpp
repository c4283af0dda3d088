#pragma once
// A vector's direction in fixed point. Mirror of rtl/fixed/rc_unit_vector.sv.
#include "model/core/payloads.hpp"

namespace rayclock {

/// Returns 2^18 / sqrt(s) for s = 1 + `sum` / 2^17 from 1 to 4, by a table of 384 entries and linear
/// interpolation over 10 bits. `sum` is a whole number below 3 * 2^17. For every s from there to the next one
/// the result is less than 0.5 too small and less than 3.7 too large. At the given s it errs by -0.24 * 2^-16
/// to 0.91 * 2^-16 (tests/unit/fixed/unit_vector_test.cpp tries them all).
std::uint32_t inverse_root(std::uint32_t sum);

/// Returns v / |v| with unit_bits fraction bits, -2^16..2^16; zero for zero. v has at most 63 bits and a
/// sign.
///
/// Bounds, in units of 2^-16. A component errs by less than 3.2: 1.74 for cutting the components to 17 bits,
/// 0.91 for the root, 0.5 for rounding. The cut moves the vector by less than sqrt 3 of at least 2^16, and
/// its direction by no more. The length is at most 1.12 too small and 1.78 too large: the root, and sqrt 3 /
/// 2 for rounding three components.
Vec3i unit_vector(const Vec3l& v);

}   // namespace rayclock
