#include "model/oracle/surface.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#include <immintrin.h>
#endif
// Vectors stay inside functions: how one would be passed does not matter.
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace rayclock::oracle {

namespace {

struct Extent {
    Vec3i lo, hi;
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
Extent extent(const Corners& t) {
    Extent box{t.a, t.a};
    box.add(t.b);
    box.add(t.c);
    return box;
}

/// Boxes of four children, [axis][child]; twice the centres and twice the half widths, to have whole numbers.
struct Boxes {
    double centre[3][4] = {}, width[3][4] = {};
};

/// A ray as the rejections want it.
struct Ray {
    double twice_o[3], d[3], size[3], forward[3];   ///< size: |d|; forward: sign of d
    std::size_t main = 0;                           ///< axis of the largest component
    std::int64_t main_size = 0;

    Ray(const Vec3i& origin, const Vec3i& direction) {
        for (std::size_t k = 0; k < 3; ++k) {
            twice_o[k] = 2.0 * origin[k];
            d[k] = direction[k];
            size[k] = std::abs(d[k]);
            forward[k] = (d[k] > 0) - (d[k] < 0);
            if (size[k] > size[main]) main = k;
        }
        main_size = std::int64_t(size[main]);
    }
    /// A box at twice the way `near` on the main axis begins after the hit.
    bool after(const ExactHit& hit, double near) const {
        return hit.primitive != no_primitive && Int128(std::int64_t(near)) * hit.den > 2 * hit.num * main_size;
    }
};

constexpr std::uint32_t leaf = 1u << 31, none = ~0u;   // of a child's number

// Every operation is exact, so both versions give the same.
namespace plain {
using Lanes = double __attribute__((vector_size(16)));
inline unsigned signs(const Lanes& v) { return unsigned(v[0] < 0) | unsigned(v[1] < 0) << 1; }
#include "model/oracle/search.inl"
} // namespace plain

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
using Lanes = double __attribute__((vector_size(32)));
inline unsigned signs(const Lanes& v) { return unsigned(_mm256_movemask_pd(_mm256_cmp_pd(__m256d(v), _mm256_setzero_pd(), _CMP_LT_OQ))); }
#include "model/oracle/search.inl"
} // namespace avx2
#pragma GCC pop_options
#define RAYCLOCK_SEARCH(closest, ...) (__builtin_cpu_supports("avx2") ? avx2::search<closest>(__VA_ARGS__) : plain::search<closest>(__VA_ARGS__))
#else
#define RAYCLOCK_SEARCH(closest, ...) plain::search<closest>(__VA_ARGS__)
#endif

} // namespace

struct Surface::Node {
    Boxes boxes;
    std::array<std::uint32_t, 4> child;   ///< a node; or, with the top bit, a place in order_; or none
    unsigned there = 0;                   ///< a bit for each child
};

Surface::~Surface() = default;

std::vector<Corners> snapped(const Scene& scene, const Lattice& lattice) {
    std::vector<Corners> triangles;
    triangles.reserve(scene.triangles.size());
    const auto corner = [&](const Triangle& t, std::size_t k) { return lattice.snap(scene.vertices[t.vertex[k]]); };
    for (const Triangle& t : scene.triangles) triangles.push_back({corner(t, 0), corner(t, 1), corner(t, 2)});
    return triangles;
}

ExactHit exact_hit(const Vec3i& o, const Vec3i& d, const Corners& triangle, std::uint32_t primitive) {
    const auto at = cross<Int128, std::int64_t>(o, d, triangle);
    return at ? ExactHit{primitive, at->num, at->den, at->sense} : ExactHit{};
}

Surface::Surface(std::vector<Corners> triangles, int margin) : triangles_(std::move(triangles)), margin_(margin), order_(triangles_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(triangles_.size());
    if (!triangles_.empty()) root_ = build(0, std::uint32_t(triangles_.size()));
    ordered_.reserve(order_.size());
    for (const std::uint32_t i : order_) ordered_.push_back(triangles_[i]);
}

/// A node over a part of order_; its number.
std::uint32_t Surface::build(std::uint32_t first, std::uint32_t count) {
    const auto bounds = [&](std::uint32_t from, std::uint32_t n) {
        Extent all = extent(triangles_[order_[from]]);
        for (std::uint32_t i = from + 1; i < from + n; ++i) {
            const Extent box = extent(triangles_[order_[i]]);
            all.add(box.lo);
            all.add(box.hi);
        }
        return all;
    };
    // Puts the lower half of a part first, along the part's longest axis; numbers decide between equals.
    const auto halve = [&](std::uint32_t from, std::uint32_t n) {
        const std::size_t axis = bounds(from, n).longest();
        const auto middle = [&](std::uint32_t i) {
            const Corners& t = triangles_[i];
            return std::pair(std::int64_t(t.a[axis]) + t.b[axis] + t.c[axis], i);
        };
        const auto begin = order_.begin() + from;
        std::nth_element(begin, begin + n / 2, begin + n, [&](std::uint32_t i, std::uint32_t j) { return middle(i) < middle(j); });
        return n / 2;
    };
    std::array<std::uint32_t, 5> cut{0, 0, count, count, count};   // of the four parts, some empty
    if (count > 1) {
        cut[2] = halve(first, count);
        cut[1] = cut[2] > 1 ? halve(first, cut[2]) : 0;
        cut[3] = count - cut[2] > 1 ? cut[2] + halve(first + cut[2], count - cut[2]) : cut[2];
    }
    const auto number = std::uint32_t(nodes_.size());
    nodes_.emplace_back();
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t from = first + cut[i], n = cut[i + 1] - cut[i];
        std::uint32_t child = none;
        if (n > 0) {
            const Extent box = bounds(from, n);
            for (std::size_t k = 0; k < 3; ++k) {
                nodes_[number].boxes.centre[k][i] = double(box.lo[k]) + box.hi[k];
                nodes_[number].boxes.width[k][i] = double(box.hi[k]) - box.lo[k] + 2 * margin_;
            }
            nodes_[number].there |= 1u << i;
            child = n == 1 ? from | leaf : build(from, n);
        }
        nodes_[number].child[i] = child;
    }
    return number;
}

ExactHit Surface::closest(const Vec3i& o, const Vec3i& d) const {
    ExactHit best;
    if (root_ == none) return best;
    RAYCLOCK_SEARCH(true, Ray(o, d), nodes_.data(), root_, best, [&](std::uint32_t place) {
        const ExactHit hit = exact_hit(o, d, ordered_[place], order_[place]);
        if (hit.primitive != no_primitive && hit.before(best)) best = hit;
    });
    return best;
}

void Surface::candidates(const Vec3i& o, const Vec3i& d, std::vector<std::uint32_t>& found) const {
    found.clear();
    if (root_ == none) return;
    RAYCLOCK_SEARCH(false, Ray(o, d), nodes_.data(), root_, ExactHit{}, [&](std::uint32_t place) { found.push_back(order_[place]); });
}

} // namespace rayclock::oracle
