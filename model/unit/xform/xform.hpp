#pragma once
// The unit xform: rays in the space of an instance.
#include "model/core/payloads.hpp"

namespace rayclock {

/// Returns a ray of the scene's space in the space of an instance's mesh.
///
/// o' = round(A o + b) and d' = round(A d) with round(y) = floor(y + 1/2), once for each ray and instance. So
/// all primitives of the instance see the same whole numbers. d' is not normalised, so a point of the ray has
/// the same t in both spaces. If the chip shades, o and o' have B fraction bits. A shadow ray's o' has none,
/// as in a flat scene. In the instance that a ray leaves, o' and d' come from shade (Home).
///
/// Widths: |o'| < 2^(N-1), |d'| <= 2^(M-1), as the absolute values in a row of A sum to at most 1. Sums
/// before rounding are below 2^(N+K) and 2^(M+K). Mirror of rtl/unit/xform/rc_xform.sv, latency
/// Config::xform_latency(), one ray every xform_interval cycles.
Change xform(const XformReq& req, const Config& config);

/// Returns A v + b, exact, with map_frac() more fraction bits than v.
Vec3l unrounded(const Placement& p, const Vec3i& v, const Vec3l& b);
/// Return o' of a ray that does not start in the instance, and d'.
Vec3i moved_point(const Placement& p, const Vec3i& o, RayKind kind, const Config& config);
Vec3i moved_direction(const Placement& p, const Vec3i& d, const Config& config);

}   // namespace rayclock
