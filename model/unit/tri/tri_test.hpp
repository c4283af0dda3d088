#pragma once
// The common form of all ray-triangle tests.
#include "model/core/payloads.hpp"

namespace rayclock {

/// A ray-triangle test as a pure function. It decides whether the ray o + t d meets `triangle` before `best`,
/// and fills all of `out` except the ray's number. Without a hit it fills zeros.
///
/// In every test o, d and the corners are lattice points, t = num / det, and `Config` bounds the widths. The
/// arithmetic inside depends on the test.
using TriTest = void(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                     const Config& config, TriRsp& out);

/// Fills the answer of a test without a hit.
inline void no_hit(TriRsp& out) {
    out.closer = out.back = out.cutout = 0;
    out.num = out.det = 0;
    out.prim = out.t = out.u = out.v = 0;
}

/// Returns the test that the configuration names. Call it once per frame, not for each triangle.
/// - exact: integers without rounding (tri.hpp). In RTL; the oracle judges it.
/// - sheared: corners rounded in the ray's plane, then exact (sheared.hpp). In RTL; judged for watertightness
///   and bounded distance.
/// - unit24: affine map to the unit triangle in 24-bit floats (baselines/unit24.hpp). In software; a baseline
///   that leaks.
/// - moller: Moller and Trumbore in float32 (baselines/moller.hpp). In software; a baseline that leaks.
/// - woop: Woop's watertight test in float32 without fallback (baselines/woop.hpp). In software; a baseline
///   that hits twice.
/// - truncated: Moller and Trumbore in Q.16 with truncated products (baselines/truncated.hpp). In software; a
///   baseline that leaks.
TriTest* tri_test_of(const Config& config);

}   // namespace rayclock
