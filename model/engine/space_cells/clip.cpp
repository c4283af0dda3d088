// Clips triangles, spheres and boxes to cells.
#include "model/engine/space_cells/clip.hpp"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace rayclock::space_cells {

namespace {

constexpr double slack = 1.0 / 1024, outward = 1.0 / (1 << 20);   // lattice steps
constexpr double wall_slack = 1.0 / 256;                          // of n . x
constexpr std::size_t max_corners = 9 + max_walls;                // three, and one more for each plane
using Corner = std::array<double, 3>;

struct Polygon {
    std::array<Corner, max_corners + 1> corners;
    std::size_t size = 0;
    void add(const Corner& corner) { corners[size++] = corner; }
};

/// A coordinate, and the rule that a corner lies exactly in its plane.
struct Along {
    std::size_t axis;
    double operator()(const Corner& c) const { return c[axis]; }
    void settle(Corner& c, double at) const { c[axis] = at; }
};
/// The product n . x.
struct Across {
    const Vec3i& n;
    double operator()(const Corner& c) const { return n[0] * c[0] + n[1] * c[1] + n[2] * c[2]; }
    void settle(Corner&, double) const {}
};

/// Keeps the part with value <= at, or >= at.
template <class Value> void cut(const Polygon& from, const Value& value, double at, bool below, Polygon& to) {
    to.size = 0;
    const auto is_in = [&](const Corner& c) { return below ? value(c) <= at : value(c) >= at; };
    for (std::size_t i = 0; i < from.size; ++i) {
        const Corner &a = from.corners[i], &b = from.corners[i + 1 < from.size ? i + 1 : 0];
        if (is_in(a)) to.add(a);
        if (is_in(a) == is_in(b)) continue;
        const double part = (at - value(a)) / (value(b) - value(a));
        Corner c;
        for (std::size_t k = 0; k < 3; ++k) c[k] = a[k] + part * (b[k] - a[k]);
        value.settle(c, at);
        to.add(c);
    }
}

/// Returns the largest change of n . x if no coordinate changes by more than 1.
int size(const Vec3i& n) { return std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]); }

Corner corner(const Vec3i& p) { return {double(p[0]), double(p[1]), double(p[2])}; }

}   // namespace

Clipper::Clipper(const PrimData& prim, int coord_bits, int margin) : prim_(prim), margin_(margin) {
    if (prim.kind == PrimKind::sphere) {
        const std::int32_t far = 1 << (coord_bits - 1);
        const std::uint64_t square = radius_squared(prim, coord_bits);
        radius_ = std::int64_t(std::sqrt(double(square)));
        while (std::uint64_t(radius_) * std::uint64_t(radius_) < square) ++radius_;
        for (std::size_t k = 0; k < 3; ++k) {
            bounds_.lo[k] = std::int32_t(prim.a[k] - radius_);
            bounds_.hi[k] = std::int32_t(prim.a[k] + radius_);
            hollow_ = hollow_ && bounds_.lo[k] > -far && bounds_.hi[k] < far;
        }
        return;
    }
    for (const Vec3i& p : {prim.a, prim.b, prim.c})
        for (std::size_t k = 0; k < 3; ++k) {
            bounds_.lo[k] = std::min(bounds_.lo[k], p[k] - margin);
            bounds_.hi[k] = std::max(bounds_.hi[k], p[k] + margin);
        }
}

Clipper::Reach Clipper::reach(const Vec3i& n) const {
    const auto across = [&](const Vec3i& p) {
        std::int64_t sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += std::int64_t(n[k]) * p[k];
        return sum;
    };
    if (is_full_) {
        Reach reach;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t lo = std::int64_t(n[k]) * bounds_.lo[k],
                               hi = std::int64_t(n[k]) * bounds_.hi[k];
            reach.lo += std::min(lo, hi);
            reach.hi += std::max(lo, hi);
        }
        return reach;
    }
    if (prim_.kind == PrimKind::sphere) {
        const auto most = std::int64_t(double(radius_ + 1) * std::sqrt(double(across(n))) + 1);
        return {across(prim_.a) - most, across(prim_.a) + most};   // a step more than the radius
    }
    const std::int64_t a = across(prim_.a), b = across(prim_.b), c = across(prim_.c);
    const auto margin = std::int64_t(margin_ * size(n));
    return {std::min({a, b, c}) - margin, std::max({a, b, c}) + margin};
}

std::optional<LatticeBox> Clipper::operator()(const LatticeBox& cell, Walls walls) const {
    LatticeBox common;
    bool whole = true;
    for (std::size_t k = 0; k < 3; ++k) {
        common.lo[k] = std::max(bounds_.lo[k], cell.lo[k]);
        common.hi[k] = std::min(bounds_.hi[k], cell.hi[k]);
        if (common.lo[k] > common.hi[k]) return {};
        whole = whole && common.lo[k] == bounds_.lo[k] && common.hi[k] == bounds_.hi[k];
    }
    if (is_full_) return common;
    if (prim_.kind == PrimKind::sphere) return meets_sphere(cell) ? std::optional(common) : std::nullopt;
    return whole && walls.empty() ? std::optional(common) : triangle(cell, walls);
}

std::optional<LatticeBox> Clipper::triangle(const LatticeBox& cell, Walls walls) const {
    Polygon one, other;
    for (const Vec3i& p : {prim_.a, prim_.b, prim_.c}) one.add(corner(p));
    for (std::size_t k = 0; k < 3 && one.size > 0; ++k) {
        cut(one, Along{k}, cell.lo[k] - margin_ - slack, false, other);
        cut(other, Along{k}, cell.hi[k] + margin_ + slack, true, one);
    }
    for (const Wall& wall : walls) {
        const double margin = wall_slack + margin_ * size(wall.normal);
        cut(one, Across{wall.normal}, wall.at + (wall.upper ? -margin : margin), !wall.upper, other);
        std::swap(one, other);
    }
    if (one.size == 0) return {};
    LatticeBox box;
    for (std::size_t k = 0; k < 3; ++k) {
        double lo = one.corners[0][k], hi = lo;
        for (std::size_t i = 1; i < one.size; ++i)
            lo = std::min(lo, one.corners[i][k]), hi = std::max(hi, one.corners[i][k]);
        box.lo[k] = std::max({cell.lo[k], bounds_.lo[k], std::int32_t(std::floor(lo - margin_ - outward))});
        box.hi[k] = std::min({cell.hi[k], bounds_.hi[k], std::int32_t(std::ceil(hi + margin_ + outward))});
        if (box.lo[k] > box.hi[k]) return {};   // it lies in the slack
    }
    return box;
}

/// Compares squared distances to the nearest and the farthest point of the cell. They are below 2^44.
bool Clipper::meets_sphere(const LatticeBox& cell) const {
    std::int64_t nearest = 0, farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t below = cell.lo[k] - std::int64_t(prim_.a[k]),
                           above = std::int64_t(prim_.a[k]) - cell.hi[k];
        const std::int64_t near = std::max({below, above, std::int64_t(0)}), far = -std::min(below, above);
        nearest += near * near;
        farthest += far * far;
    }
    const std::int64_t outer = radius_ + 1, inner = hollow_ ? std::max<std::int64_t>(0, radius_ - 2) : 0;
    return nearest <= outer * outer && farthest >= inner * inner;
}

}   // namespace rayclock::space_cells
