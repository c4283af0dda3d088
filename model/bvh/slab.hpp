#pragma once
// The slab test's data in the form in which the arithmetic wants it. The arithmetic itself is slab.inl.
#include <bit>
#include <cstring>

#include "model/bvh/box.hpp"

// With this, slab.inl and what includes it are compiled twice, for the baseline and for AVX2, and the
// processor decides. The results are the same, since every operation is exact.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define RAYCLOCK_AVX2 1
#include <immintrin.h>
#endif
// Everything that takes or returns a vector is inlined: how one would be passed does not matter.
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wpsabi"
#endif
#define RAYCLOCK_INLINE inline __attribute__((always_inline))

namespace rayclock {

// Four axes or children at a time, in double precision: every value is a whole number below 2^53 times a
// power of two, so that products, sums and comparisons are exact and no rounding is left to the machine.
using Lanes = double __attribute__((vector_size(32)));
using Mask = std::int64_t __attribute__((vector_size(32)));
using Whole = std::int32_t __attribute__((vector_size(16)));

/// What the slab test needs of a ray, lane k for axis k; the fourth lane is 0.
struct SlabRay {
    Lanes near_o,
        far_o;         ///< lattice points from which near and far planes are measured; a bounce may have two
    Lanes near, far;   ///< signed r and r + 1
    Mask scale;        ///< of a step of lattice times r, to t's unit: a double's exponent
    double beyond, past;   ///< all ones, and 1 more
    std::array<std::uint32_t, 3> near_at,
        far_at;   ///< where the axis' near and far planes begin in WideNode::planes
    std::array<bool, 3> zero;
    bool zeros;   ///< any
};

// Whole vectors are made, as a vector read from parts just written would have to wait for them.
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

/// Sorts of small sets of keys.
namespace keys {

/// Puts two keys in order without a branch, which no predictor could guess.
RAYCLOCK_INLINE void order(std::uint64_t& a, std::uint64_t& b) {
    const std::uint64_t least = b < a ? b : a;
    b = b < a ? a : b;
    a = least;
}
/// Batcher's merge sort of the first four or of all eight.
RAYCLOCK_INLINE void sort_four(std::uint64_t* k) {
    order(k[0], k[1]), order(k[2], k[3]);
    order(k[0], k[2]), order(k[1], k[3]);
    order(k[1], k[2]);
}
RAYCLOCK_INLINE void sort_eight(std::uint64_t* k) {
    sort_four(k);
    sort_four(k + 4);
    order(k[0], k[4]), order(k[1], k[5]), order(k[2], k[6]), order(k[3], k[7]);
    order(k[2], k[4]), order(k[3], k[5]);
    order(k[1], k[2]), order(k[3], k[4]), order(k[5], k[6]);
}

}   // namespace keys

/// The children in `set` (bit i: child i) by (t_near, place in the node): their keys in order. A key is
/// t_near << 3 | child. `sorted` has room for eight and more than the result may be written. Returns how many
/// there are.
RAYCLOCK_INLINE std::uint32_t sort_children(std::uint32_t set, const std::uint32_t* t_near,
                                            std::uint64_t* sorted) {
    const auto take = [&] {
        const auto child = std::uint32_t(std::countr_zero(set));
        set &= set - 1;
        return std::uint64_t(t_near[child]) << 3 | child;
    };
    if (set == 0) return 0;
    sorted[0] = take();
    if (set == 0) return 1;
    sorted[1] = take();
    if (set == 0) {
        keys::order(sorted[0], sorted[1]);
        return 2;
    }
    std::uint32_t count = 2;
    do sorted[count++] = take();
    while (set != 0);
    for (std::uint32_t i = count; i < max_width; ++i) sorted[i] = ~std::uint64_t(0);
    if (count <= 4)
        keys::sort_four(sorted);
    else
        keys::sort_eight(sorted);
    return count;
}

}   // namespace rayclock
