#pragma once
// The data of the slab test, laid out for its arithmetic in slab.inl.
#include <cstring>

#include "model/engine/bvh/box.hpp"
#include "model/unit/trav/order.hpp"

// Compiles slab.inl and its users twice, for the baseline and for AVX2; the processor's features choose. The
// results are equal, since every operation is exact.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define RAYCLOCK_AVX2 1
#include <immintrin.h>
#endif
// Every function with a vector argument or result is inlined, so the calling convention does not matter.
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace rayclock {

// Four axes or children at a time, in double precision. Every value is a whole number below 2^53 times a
// power of two. So products, sums and comparisons are exact and do not depend on the machine's rounding.
using Lanes = double __attribute__((vector_size(32)));
using Mask = std::int64_t __attribute__((vector_size(32)));
using Whole = std::int32_t __attribute__((vector_size(16)));

/// The part of a ray that the slab test uses, lane k for axis k. The fourth lane is 0.
struct SlabRay {
    /// Lattice points from which near and far planes are measured. They may differ for a bounce.
    Lanes near_o, far_o;
    Lanes near, far;       ///< r and r + 1, with the sign of the direction
    Mask scale;            ///< scale from lattice steps times r to t's unit, as a double's exponent
    double beyond, past;   ///< all ones, and one more
    /// Start of the axis' near and far planes in WideNode::planes.
    std::array<std::uint32_t, 3> near_at, far_at;
    std::array<bool, 3> zero;
    bool zeros;   ///< true if any axis is zero
};

// Builds whole vectors. A vector read from parts that were just written would wait for those writes.
inline SlabRay slab_ray(const BoxRay& ray, const Config& c) {
    SlabRay slab{};
    const auto turned = [&](std::size_t k, std::int32_t r) { return double(ray.neg[k] != 0 ? -r : r); };
    const auto r = [&](std::size_t k) { return turned(k, std::int32_t(ray.recip[k])); };
    const auto r_up = [&](std::size_t k) {
        return turned(k, std::int32_t(ray.recip[k]) + (ray.len[k] != 0));
    };
    const int frac = c.origin_frac();
    const std::int32_t rest = (1 << frac) - 1;
    const auto before = [&](std::size_t k) {
        return double((ray.o[k] + (ray.neg[k] != 0 ? rest : 0)) >> frac);
    };
    const auto beyond = [&](std::size_t k) {
        return double((ray.o[k] + (ray.neg[k] != 0 ? 0 : rest)) >> frac);
    };
    slab.near_o = Lanes{beyond(0), beyond(1), beyond(2), 0};
    slab.far_o = Lanes{before(0), before(1), before(2), 0};
    slab.near = Lanes{r(0), r(1), r(2), 0};
    slab.far = Lanes{r_up(0), r_up(1), r_up(2), 0};
    const int unit = 1023 + c.t_frac_bits + c.ray_dir_bits() - c.recip_bits;
    slab.scale = Mask{unit - int(ray.len[0]), unit - int(ray.len[1]), unit - int(ray.len[2]), 0} << 52;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t lo = std::uint32_t(k * max_width), hi = lo + 3 * max_width;
        slab.near_at[k] = ray.neg[k] != 0 ? hi : lo;
        slab.far_at[k] = ray.neg[k] != 0 ? lo : hi;
        slab.zero[k] = ray.len[k] == 0;
    }
    slab.zeros = ray.len[0] == 0 || ray.len[1] == 0 || ray.len[2] == 0;
    slab.beyond = double((1u << c.t_bits()) - 1);
    slab.past = slab.beyond + 1;
    return slab;
}

}   // namespace rayclock
