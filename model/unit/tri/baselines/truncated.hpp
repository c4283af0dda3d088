#pragma once
// A triangle test in truncated fixed point, a baseline.
#include "model/unit/tri/tri_test.hpp"

namespace rayclock {

/// Baseline: Moller and Trumbore in Q.16 fixed point, as in a typical first FPGA ray tracer. The lattice is
/// the cube from -1 to 1: a coordinate is x 2^(17-N), cut to a whole number for N > 17. A direction is d
/// 2^(17-M), cut in the same way. Every product is immediately cut down to 16 fraction bits (an arithmetic
/// shift). A point with u, v >= 0 and u + v <= det belongs to the triangle. Edges leak. In software only.
///
/// Widths: coordinates 17 bits, differences 18, directions 17, d x e 20, det, u, v 22; nothing overflows.
void truncated_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                    const Config& config, TriRsp& out);

}   // namespace rayclock
