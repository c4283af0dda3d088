#pragma once
#include "model/unit/isect/primitive.hpp"

namespace rayclock {

/// Baseline: Moller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection", in float32 without
/// contraction; both sides are seen, det = 0 takes nothing, no epsilon. Coordinates and directions are at
/// most 24 bits: exact in a float, so all that is lost is lost here. Edges leak. In software only.
void moller_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                 const Config& config, TriRsp& out);

}   // namespace rayclock
