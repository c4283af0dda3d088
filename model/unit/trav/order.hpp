#pragma once
// The order in which a ray visits children: nearest first, equals by their place in the node.
#include <bit>

#include "model/core/payloads.hpp"

#define RAYCLOCK_INLINE inline __attribute__((always_inline))

namespace rayclock {

/// Sorts of small sets of keys.
namespace keys {

/// Sorts two keys without a branch, which no predictor could guess.
RAYCLOCK_INLINE void order(std::uint64_t& a, std::uint64_t& b) {
    const std::uint64_t least = b < a ? b : a;
    b = b < a ? a : b;
    a = least;
}
/// Batcher's merge sort of the first four keys, or of all eight.
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

/// Sorts the children in `set` (bit i: child i) by (t_near, place in the node), and writes their keys to
/// `sorted`. A key is t_near << 3 | child. `sorted` must have room for eight keys, because more than the
/// result may be written. Returns the number of keys.
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

/// The machine's order, as a parameter of GroupStack and TreeWalk.
struct ByDistance {
    using Time = std::uint32_t;
    using Key = std::uint64_t;   ///< t_near << 3 | child
    static Key key(Time t_near, std::uint32_t child) { return Key(t_near) << 3 | child; }
    static Time near(Key key) { return Time(key >> 3); }
    static std::uint32_t child(Key key) { return std::uint32_t(key) & (max_width - 1); }
    RAYCLOCK_INLINE static std::uint32_t sort(std::uint32_t set, const Time* t_near, Key* sorted) {
        return sort_children(set, t_near, sorted);
    }
};

}   // namespace rayclock
