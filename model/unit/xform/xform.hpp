#pragma once
#include "model/core/payloads.hpp"

namespace rayclock {

/// A ray of the scene's space in the space of an instance's mesh.
///
/// o' = round(A o + b), d' = round(A d), round(y) = floor(y + 1/2), once for each ray and instance: all
/// primitives of the instance see the same whole numbers. d' is not normalised, so a point of the ray has the
/// same t in both spaces. If the chip shades, o and o' have B fraction bits; a shadow ray's o' has none, as
/// that of a flat scene, and of the instance that a ray leaves, o' and d' are what shade has made (Home).
/// Widths: |o'| < 2^(N-1), |d'| <= 2^(M-1), as rows of A sum to 1 at most; sums before rounding are below
/// 2^(N+K) and 2^(M+K). Mirror of rtl/unit/xform/rc_xform.sv, latency Config::xform_latency(), one ray every
/// xform_interval cycles.
Change xform(const XformReq& req, const Config& config);

/// A v + b with map_frac() fraction bits more than v has: exact.
Vec3l unrounded(const Placement& p, const Vec3i& v, const Vec3l& b);
/// o' of a ray that comes from elsewhere, and d'.
Vec3i moved_point(const Placement& p, const Vec3i& o, RayKind kind, const Config& config);
Vec3i moved_direction(const Placement& p, const Vec3i& d, const Config& config);

}   // namespace rayclock
