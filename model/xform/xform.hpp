#pragma once
#include "model/core/payloads.hpp"

namespace rayclock {

/// A ray of the scene's space in the space of an instance's mesh.
///
/// o' = round(A o + b), d' = round(A d), round(y) = floor(y + 1/2), once for each ray and instance: all
/// primitives of the instance see the same whole numbers. d' is not normalised, so a point of the ray has the
/// same t in both spaces. Widths: |o'| < 2^(N-1), |d'| <= 2^(M-1), as rows of A sum to 1 at most; sums before
/// rounding are below 2^(N+K) and 2^(M+K). Mirror of rtl/xform/rc_xform.sv, latency Config::xform_latency(),
/// one ray every xform_interval cycles.
Change xform(const XformReq& req, const Config& config);

}   // namespace rayclock
