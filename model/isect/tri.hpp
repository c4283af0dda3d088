#pragma once
#include "model/core/payloads.hpp"

namespace rayclock {

/// Ray-triangle test with exact decisions.
///
/// With e1 = b - a, e2 = c - a, s = o - a (Moller and Trumbore 1997, without division):
///   P1 = d x e1, P2 = d x e2, det = P2 . e1, u = P2 . s, v = -P1 . s, w = det - u - v, num = (e1 x e2) . s,
/// all turned so that det > 0. The ray's line crosses the triangle where u, v, w >= 0, at t = num / det > 0.
///
/// Ties: an edge function that is exactly zero takes the sign that it would have for the origin o + (eps, eps^2, eps^3),
/// an infinitesimal step that all triangles share (simulation of simplicity, Edelsbrunner and Muecke 1990): the first
/// non-zero component of its gradient, P2 for u, -P1 for v, P1 - P2 for w. So two triangles that share an edge never
/// both take or both lose a ray; a triangle seen edge-on (det = 0) takes none.
///
/// Closest: num1 det2 < num2 det1, exact; equal t goes to the lower primitive number.
/// Widths: |u|, |v|, |w|, det < 2^(2N+M+1), |num| < 2^(3N+1).
/// Mirror of rtl/isect/rc_tri.sv, latency Config::tri_latency() + 1, one triangle per cycle.
void tri_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best, const Config& config, TriRsp& out);
TriRsp tri(const TriReq& req, const Config& config);

} // namespace rayclock
