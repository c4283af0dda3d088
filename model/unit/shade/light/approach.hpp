#pragma once
// The way of distant rays to the lattice.
#include <optional>

#include "model/core/frame.hpp"

namespace rayclock {

/// Returns the largest coordinate of a ray's origin: that of the lattice, with B fraction bits.
inline std::int64_t lattice_end(const Config& c) {
    return ((std::int64_t(1) << (c.coord_bits - 1)) - 1) << c.origin_bits;
}

/// Returns the point where a ray that begins on a plane beyond the lattice enters it: p + k 2^s d with
/// s = Config::approach_shift(). k is the least whole k > 0 for which no slab of the lattice lies ahead. The
/// result is empty if that point is outside, because the ray misses the lattice.
///
/// The point is exactly on the ray: nothing is rounded. It lies further in than the ray's entry by less than
/// 2^(s + M - 2), an eighth of the lattice's reach (unless s = 0). fit_lattice() leaves that margin free, so
/// the ray skips no bounded primitive. k has approach_steps bits. These suffice from 2^light_reach times the
/// lattice's reach, with |d| of 2^(M-2) as direction_of() makes it. Mirror of
/// rtl/unit/shade/light/rc_approach.sv.
std::optional<Vec3i> approach(const Vec3l& p, const Vec3i& d, const Config& config);

}   // namespace rayclock
