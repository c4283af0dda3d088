#pragma once
// The sheared triangle test of unit tri, as pure functions.
#include "model/unit/tri/tri_test.hpp"

namespace rayclock {

/// Ray-triangle test in the ray's own plane (Woop, Benthin, Wald 2013, "Watertight ray/triangle
/// intersection"), in integers.
///
/// z is the axis of the largest |d| (the lowest among equals), x and y the next two in turn. A ray's Shear,
/// computed once per ray, has
///       slope_x = d_x / d_z, rounded to S = M - 2 fraction bits, halves away from zero;
///       slope_y in the same way.
/// A corner p, seen from the origin as r = p - o, becomes the point
///       X = floor(r_x - slope_x r_z + 1/2), Y in the same way:
/// a lattice point of the plane, with one rounding each. It depends only on the corner and the ray, so all
/// triangles around a corner see it in the same place. From there on every decision is exact:
///       u = C x A, v = A x B, w = B x C, det = u + v + w (2-D cross products),
///       num = |d_z| / d_z * (w A_z + u B_z + v C_z),
/// all turned so that det > 0. The ray crosses where u, v, w >= 0, at z distance num / det > 0, that is
/// t = num / (det |d_z|). |d_z| is the same for all triangles of a ray, so the test compares num / det.
///
/// Ties: an edge function of P, Q that is zero takes the sign that it would have if the ray's point (0, 0)
/// were (eps, eps^2). That is the sign of Y_P - Y_Q, and if that is zero, of X_Q - X_P. Two triangles that
/// share an edge see opposite signs. A triangle that is flat in the plane (det = 0) takes no ray. So a ray
/// crosses a closed surface as often inwards as outwards, always.
///
/// Error bound: a corner moves by at most 1/2 (its rounding) + 2^N 2^-(S+1) (the slope's) in x and in y. With
/// M >= N + 2, which check_config requires, that is at most one lattice step. So a triangle that takes the
/// ray has a point at z distance num / det within one step of the ray in x and in y. A triangle that loses a
/// ray which the exact test takes has an edge that near. The compiled boxes are one step larger than their
/// triangles, so the tree loses none of them.
///
/// Widths: |X| <= 2^(N+1) - 2: N + 2 bits. Two corners differ by at most 2^(N+1) - 2 in X and in Y, and twice
/// a triangle's area is at most the area of its bounding rectangle: det < 2^(2N+2). |A_z| < 2^N:
/// num < 2^(3N+2).
///
/// Mirror of rtl/unit/tri/rc_shear.sv in rc_tri.sv, latency Config::tri_latency() + 1, one
/// triangle every Config::tri_interval cycles.
void sheared_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                  const Config& config, TriRsp& out);

/// Performs the same test with the ray's precomputed shear.
void sheared_test(const Vec3i& o, const Shear& shear, const PrimData& triangle, const Best& best,
                  const Config& config, TriRsp& out);

/// Returns the shear of a direction; all zero for d = 0, which no triangle takes. Mirror of
/// rtl/unit/raygen/rc_slope.sv.
Shear shear_of(const Vec3i& d, const Config& config);

}   // namespace rayclock
