#pragma once
// The float32 triangle test of Moller and Trumbore, a baseline.
#include "model/unit/tri/tri_test.hpp"

namespace rayclock {

/// Baseline: Moller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection", in float32 without
/// contraction. It sees both sides of a triangle, det = 0 takes no ray, and it has no epsilon. Coordinates
/// and directions have at most 24 bits and are exact in a float, so only this test loses precision. Edges
/// leak. In software only.
void moller_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                 const Config& config, TriRsp& out);

}   // namespace rayclock
