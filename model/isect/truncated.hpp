#pragma once
#include "model/isect/primitive.hpp"

namespace rayclock {

/// Baseline: Moller and Trumbore in Q.16 fixed point, what a first FPGA ray tracer does. The lattice is the unit cube: a
/// coordinate is x 2^(16-N), cut to a whole number for N > 16; a direction d 2^(17-M), likewise. Every product is cut to 16
/// fraction bits at once, downwards (an arithmetic shift). u, v >= 0 and u + v <= det belong to the triangle. Edges leak.
/// In software only.
///
/// Widths: coordinates 16 bits, differences 17, directions 18, d x e 19, det, u, v 20; nothing overflows.
void truncated_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best, const Config& config, TriRsp& out);

} // namespace rayclock
