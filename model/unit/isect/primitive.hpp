#pragma once
#include "model/core/payloads.hpp"

namespace rayclock {

/// A ray-triangle test as a pure function: whether the ray o + t d meets `triangle` before `best`, and if so
/// where. Fills all of `out` but the ray's number; zeros if it does not.
///
/// Whatever the test's own arithmetic is, o, d and the corners are lattice points, t = num / det, and
/// `Config` bounds the widths.
using TriTest = void(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                     const Config& config, TriRsp& out);

/// The answer of a test that does not hit.
inline void no_hit(TriRsp& out) {
    out.closer = out.back = 0;
    out.num = out.det = 0;
    out.prim = out.t = out.u = out.v = 0;
}

/// The test that the configuration names. Chosen once for a frame, not for each triangle.
///
/// | name      | arithmetic                                                     | in      | judged by |
/// |-----------|----------------------------------------------------------------|---------|--------------------------------|
/// | exact     | integers, no rounding (tri.hpp)                                | RTL     | the oracle | |
/// sheared   | corners rounded in the ray's plane, then exact (sheared.hpp)   | RTL     | watertight; bounded
/// distance   | | unit24    | affine map to the unit triangle, 24-bit float (unit24.hpp)     | software| a
/// baseline: it leaks           | | moller    | Moller and Trumbore in float32 (moller.hpp) | software| a
/// baseline: it leaks           | | woop      | Woop's watertight test in float32, no fallback (woop.hpp) |
/// software| a baseline: hits twice         | | truncated | Moller and Trumbore in Q.16, products truncated
/// (truncated.hpp)| software| a baseline: it leaks           |
TriTest* tri_test_of(const Config& config);

}   // namespace rayclock
