#pragma once
// The float32 triangle test of Woop, Benthin and Wald, a baseline.
#include "model/unit/tri/tri_test.hpp"

namespace rayclock {

/// Baseline: Woop, Benthin and Wald 2013, "Watertight ray/triangle intersection", in float32 without
/// contraction and without its fallback to double. An edge function of exactly zero counts for both sides, so
/// edges are hit twice. The same holds for one that underflows or rounds to zero. In software only.
void woop_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
               const Config& config, TriRsp& out);

}   // namespace rayclock
