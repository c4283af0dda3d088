#pragma once
// The triangle test of SaarCOR and RPU in 24-bit floats, a baseline.
#include "model/unit/tri/tri_test.hpp"

namespace rayclock {

/// Baseline: the unit-triangle test of SaarCOR and RPU in their 24-bit floats. An affine map takes a, b, c
/// and the point a + n, n = (b - a) x (c - a), to (0,0,0), (1,0,0), (0,1,0) and (0,0,1). It maps origin and
/// direction, and then
///       t = -o_z / d_z, u = o_x + t d_x, v = o_y + t d_y.
/// A point with u, v >= 0 and u + v <= 1 belongs to the triangle. The map is computed in double and each of
/// its twelve numbers rounded once. Two matrices map the corners that two triangles share, so edges leak. In
/// software only.
///
/// Float: 1 sign, 7 exponent and 16 mantissa bits, to nearest, ties to even (the format is published, its
/// rounding is assumed). The bias is 63; values below the least normal number are zero, above the largest
/// infinite. Additions run from the left (assumed).
void unit24_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                 const Config& config, TriRsp& out);

/// Returns x rounded to a 24-bit float. For a double sum, product or quotient of two such floats the result
/// is the correct rounding of the operation itself. 53 bits are at least 2 * 17 + 2, so rounding twice equals
/// rounding once (Figueroa 1995, "When is double rounding innocuous?").
double float24(double x);

}   // namespace rayclock
