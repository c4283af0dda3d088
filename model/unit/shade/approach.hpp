#pragma once
#include <optional>

#include "model/core/frame.hpp"

namespace rayclock {

/// The largest coordinate of a ray's origin: the lattice's, with B fraction bits.
inline std::int64_t lattice_end(const Config& c) {
    return ((std::int64_t(1) << (c.coord_bits - 1)) - 1) << c.origin_bits;
}

/// Where a ray that begins on a plane beyond the lattice comes into it: p + k 2^s d, s =
/// Config::approach_shift(), with the least whole k > 0 for which no slab of the lattice still lies ahead;
/// nothing if that point is outside, as the ray passes by the lattice. Exactly on the ray: nothing is
/// rounded. By less than 2^(s + M - 2), an eighth of what the lattice reaches (unless s = 0), it goes further
/// in than the ray's entry; there fit_lattice() leaves room, so that nothing with an end is passed over. k
/// has approach_steps bits: with |d| of 2^(M-2), as direction_of() makes it, more are not needed from
/// 2^light_reach times as far as the lattice reaches. Mirror of rtl/unit/shade/rc_approach.sv.
std::optional<Vec3i> approach(const Vec3l& p, const Vec3i& d, const Config& config);

}   // namespace rayclock
