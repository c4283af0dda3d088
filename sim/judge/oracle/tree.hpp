#pragma once
// The oracle's own search tree over boxes in whole lattice steps: four children per node, split at medians.
//
// The search skips no box that a ray meets. It skips a subtree only if no point o + s d, s >= 0, lies in the
// closed box around its boxes. Each of these reasons suffices:
// - On some axis the box lies behind the origin.
// - For two axes i and j, f(p) = d_i (p_j - o_j) - d_j (p_i - o_i) has one sign in all of the box. This
//   f is 0 along the whole ray. It is linear, so its extremes are centre +- half widths. This covers d_i = 0
//   with the box next to the ray.
// - `after` rejects the distance of the box's near plane on the main axis.
//
// If the origin is a lattice point, all values are integers below 2^53, so doubles hold them exactly. The
// largest is twice a difference times a direction (N + 2 + M bits), and a sum of two. For other origins, and
// for longer directions, the boxes need a margin of one step. The error of a product is below 2^-50 of it. So
// it is below a step's share |d_i| or |d_j|, as long as coordinates have at most 2^21 steps.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "sim/judge/oracle/cross.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#include <immintrin.h>
#endif

namespace rayclock::oracle {

/// A box in lattice steps.
struct Extent {
    Vec3i lo{}, hi{};
    void add(const Vec3i& p) {
        for (std::size_t k = 0; k < 3; ++k) {
            lo[k] = std::min(lo[k], p[k]);
            hi[k] = std::max(hi[k], p[k]);
        }
    }
    std::size_t longest() const {
        std::size_t axis = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
        return axis;
    }
};

inline Extent extent(const Corners& t) {
    Extent box{t.a, t.a};
    box.add(t.b);
    box.add(t.c);
    return box;
}

namespace tree {

/// The boxes of four children, [axis][child]. Twice the centres and twice the half widths are integers.
struct Boxes {
    double centre[3][4] = {}, width[3][4] = {};
};

/// A ray in the form that the rejection tests use.
struct Ray {
    double twice_o[3], d[3], size[3], forward[3];   ///< size: |d|; forward: sign of d
    std::size_t main = 0;                           ///< axis of the largest component

    Ray(const glm::dvec3& origin, const glm::dvec3& direction) {
        for (std::size_t k = 0; k < 3; ++k) {
            twice_o[k] = 2 * origin[int(k)];
            d[k] = direction[int(k)];
            size[k] = std::abs(d[k]);
            forward[k] = (d[k] > 0) - (d[k] < 0);
            if (size[k] > size[main]) main = k;
        }
    }
    /// Converts a ray from origin / 2^frac.
    Ray(const Vec3i& o, const Vec3i& direction, int frac = 0)
        : Ray(std::ldexp(1.0, -frac) * glm::dvec3(o[0], o[1], o[2]),
              glm::dvec3(direction[0], direction[1], direction[2])) {}
    double main_size() const { return size[main]; }
};

constexpr std::uint32_t leaf = 1u << 31, none = ~0u;   // values of a child's number

struct Node {
    Boxes boxes;
    std::array<std::uint32_t, 4> child;   ///< a node; with the top bit a position in the order; or none
    unsigned there = 0;                   ///< one bit per child
};

// Vectors stay inside functions, so the ABI by which they would be passed does not matter.
#ifdef __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
#endif
// Every operation yields the same value in both versions.
namespace plain {
using Lanes = double __attribute__((vector_size(16)));
inline unsigned signs(const Lanes& v) { return unsigned(v[0] < 0) | unsigned(v[1] < 0) << 1; }
#include "sim/judge/oracle/search.inl"
}   // namespace plain

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
using Lanes = double __attribute__((vector_size(32)));
inline unsigned signs(const Lanes& v) {
    return unsigned(_mm256_movemask_pd(_mm256_cmp_pd(__m256d(v), _mm256_setzero_pd(), _CMP_LT_OQ)));
}
#include "sim/judge/oracle/search.inl"
}   // namespace avx2
#pragma GCC pop_options
#endif
#ifdef __GNUC__
#pragma GCC diagnostic pop
#endif

}   // namespace tree

/// The tree. Searching takes any ray; see above for the margin.
class Tree {
public:
    /// Builds the tree. Enlarges the boxes by `margin` lattice steps on all sides.
    explicit Tree(const std::vector<Extent>& boxes, int margin = 0);

    /// Returns the boxes' numbers in the order of the leaves. The argument of meet() below is a position in
    /// it.
    const std::vector<std::uint32_t>& order() const { return order_; }

    /// Calls meet(place) for every box that the ray may meet, nearer ones first. Skips boxes for which
    /// after(near) is true: `near` is twice the distance to a box's near plane along the ray's main axis.
    template <class After, class Meet>
    void nearest_first(const tree::Ray& ray, const After& after, const Meet& meet) const {
        search<true>(ray, after, meet);
    }
    /// Calls meet(place) for every such box in any order.
    template <class Meet> void all(const tree::Ray& ray, const Meet& meet) const {
        search<false>(
            ray, [](double) { return false; }, meet);
    }

private:
    std::uint32_t build(const std::vector<Extent>& boxes, int margin, std::uint32_t first,
                        std::uint32_t count);
    template <bool in_order, class After, class Meet>
    void search(const tree::Ray& ray, const After& after, const Meet& meet) const {
        if (root_ == tree::none) return;
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
        if (__builtin_cpu_supports("avx2"))
            return tree::avx2::search<in_order>(ray, nodes_.data(), root_, after, meet);
#endif
        tree::plain::search<in_order>(ray, nodes_.data(), root_, after, meet);
    }

    std::vector<std::uint32_t> order_;
    std::vector<tree::Node> nodes_;
    std::uint32_t root_ = tree::none;
};

}   // namespace rayclock::oracle
