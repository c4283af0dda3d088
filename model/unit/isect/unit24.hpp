#pragma once
#include "model/unit/isect/primitive.hpp"

namespace rayclock {

/// Baseline: the unit-triangle test of SaarCOR and RPU in their 24-bit floats. An affine map takes a, b, c
/// and the point a + n, n = (b - a) x (c - a), to (0,0,0), (1,0,0), (0,1,0) and (0,0,1); origin and direction
/// are mapped, and then
///   t = -o_z / d_z, u = o_x + t d_x, v = o_y + t d_y; u, v >= 0 and u + v <= 1 belong to the triangle.
/// The map is computed in double and each of its twelve numbers rounded once; corners that two triangles
/// share are mapped by two matrices, so edges leak. In software only.
///
/// Float: 1 sign, 7 exponent, 16 mantissa bits, to nearest, ties to even (the format is published, its
/// rounding is assumed); bias 63, below the least normal number zero, above the largest infinite. The order
/// of additions is assumed, from the left.
void unit24_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                 const Config& config, TriRsp& out);

/// x rounded to a 24-bit float. Of a double sum, product or quotient of two such floats this is the
/// operation's own correct rounding: 53 bits are at least 2 * 17 + 2, so rounding twice is rounding once
/// (Figueroa 1995, "When is double rounding innocuous?").
double float24(double x);

}   // namespace rayclock
