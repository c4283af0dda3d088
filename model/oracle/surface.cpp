#include "model/oracle/surface.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace rayclock::oracle {

namespace {

constexpr std::uint32_t leaf_size = 4;

struct Extent {
    Vec3i lo, hi;
    void add(const Vec3i& p) {
        for (std::size_t k = 0; k < 3; ++k) {
            lo[k] = std::min(lo[k], p[k]);
            hi[k] = std::max(hi[k], p[k]);
        }
    }
};
Extent extent(const Corners& t) {
    Extent box{t.a, t.a};
    box.add(t.b);
    box.add(t.c);
    return box;
}

/// A ray as the rejections want it.
struct Probe {
    std::array<std::int64_t, 3> o, d, size;   ///< size: |d|
    std::size_t main = 0;                     ///< axis of the largest component
    Probe(const Vec3i& origin, const Vec3i& direction) {
        for (std::size_t k = 0; k < 3; ++k) {
            o[k] = origin[k];
            d[k] = direction[k];
            size[k] = std::abs(d[k]);
            if (size[k] > size[main]) main = k;
        }
    }
    /// The line passes the box by, as seen along axis k = 3 - i - j. Twice the distances, to have whole centres.
    bool beside(const Vec3i& lo, const Vec3i& hi, std::size_t i, std::size_t j) const {
        const std::int64_t centre_i = std::int64_t(lo[i]) + hi[i] - 2 * o[i], centre_j = std::int64_t(lo[j]) + hi[j] - 2 * o[j];
        const std::int64_t reach = size[i] * (std::int64_t(hi[j]) - lo[j]) + size[j] * (std::int64_t(hi[i]) - lo[i]);
        return std::abs(d[i] * centre_j - d[j] * centre_i) > reach;
    }
    bool misses(const Vec3i& lo, const Vec3i& hi) const {
        for (std::size_t k = 0; k < 3; ++k)
            if ((d[k] >= 0 && hi[k] < o[k]) || (d[k] <= 0 && lo[k] > o[k])) return true;
        return beside(lo, hi, 0, 1) || beside(lo, hi, 1, 2) || beside(lo, hi, 2, 0);
    }
    /// The box begins after the hit, on the main axis.
    bool after(const ExactHit& hit, const Vec3i& lo, const Vec3i& hi) const {
        const std::int64_t way = d[main] > 0 ? lo[main] - o[main] : o[main] - hi[main];
        return hit.primitive != no_primitive && Int128(way) * hit.den > hit.num * size[main];
    }
};

} // namespace

std::vector<Corners> snapped(const Scene& scene, const Lattice& lattice) {
    std::vector<Corners> triangles;
    triangles.reserve(scene.triangles.size());
    const auto corner = [&](const Triangle& t, std::size_t k) { return lattice.snap(scene.vertices[t.vertex[k]]); };
    for (const Triangle& t : scene.triangles) triangles.push_back({corner(t, 0), corner(t, 1), corner(t, 2)});
    return triangles;
}

ExactHit exact_hit(const Vec3i& o, const Vec3i& d, const Corners& triangle, std::uint32_t primitive) {
    const auto at = cross<Int128>(o, d, triangle);
    return at ? ExactHit{primitive, at->num, at->den, at->sense} : ExactHit{};
}

Surface::Surface(std::vector<Corners> triangles) : triangles_(std::move(triangles)), order_(triangles_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.resize(1);
    if (!triangles_.empty()) build(0, 0, std::uint32_t(triangles_.size()));
    ordered_.reserve(order_.size());
    for (const std::uint32_t i : order_) ordered_.push_back(triangles_[i]);
}

void Surface::build(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
    Extent all = extent(triangles_[order_[first]]);
    for (std::uint32_t i = first; i < first + count; ++i) {
        const Extent box = extent(triangles_[order_[i]]);
        all.add(box.lo);
        all.add(box.hi);
    }
    nodes_[node].lo = all.lo;
    nodes_[node].hi = all.hi;
    if (count <= leaf_size) {
        nodes_[node].first = first;
        nodes_[node].count = std::uint16_t(count);
        return;
    }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (std::int64_t(all.hi[k]) - all.lo[k] > std::int64_t(all.hi[axis]) - all.lo[axis]) axis = k;
    const auto middle = [&](std::uint32_t i) {
        const Corners& t = triangles_[i];
        return std::int64_t(t.a[axis]) + t.b[axis] + t.c[axis];
    };
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t i, std::uint32_t j) { return std::pair(middle(i), i) < std::pair(middle(j), j); });
    const auto child = std::uint32_t(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node].first = child;
    nodes_[node].axis = std::uint16_t(axis);
    build(child, first, count / 2);
    build(child + 1, first + count / 2, count - count / 2);
}

/// Calls meet(place in ordered_) for every triangle whose leaf's box the ray meets, and not after `best`, which meet may change.
template <class Meet> void Surface::walk(const Vec3i& o, const Vec3i& d, const ExactHit& best, const Meet& meet) const {
    if (triangles_.empty()) return;
    const Probe ray(o, d);
    std::array<std::uint32_t, 64> stack;   // 2^32 triangles halved: at most 32 levels
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = nodes_[stack[--depth]];
        if (ray.misses(node.lo, node.hi) || ray.after(best, node.lo, node.hi)) continue;
        if (node.count == 0) {
            const std::uint32_t nearer = d[node.axis] < 0 ? 1 : 0;
            stack[depth++] = node.first + 1 - nearer;
            stack[depth++] = node.first + nearer;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) meet(i);
    }
}

ExactHit Surface::closest(const Vec3i& o, const Vec3i& d) const {
    ExactHit best;
    walk(o, d, best, [&](std::uint32_t place) {
        const ExactHit hit = exact_hit(o, d, ordered_[place], order_[place]);
        if (hit.primitive != no_primitive && hit.before(best)) best = hit;
    });
    return best;
}

void Surface::candidates(const Vec3i& o, const Vec3i& d, std::vector<std::uint32_t>& found) const {
    found.clear();
    walk(o, d, ExactHit{}, [&](std::uint32_t place) { found.push_back(order_[place]); });
}

} // namespace rayclock::oracle
