#include "sim/load/triangulate.hpp"

#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace rayclock {
namespace {

using Points = std::vector<glm::dvec2>;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Twice the signed area.
double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { return cross(b - a, c - a); }

/// Drops the axis along which the polygon's area is largest; the result runs counter-clockwise.
Points flatten(std::span<const glm::dvec3> corners) {
    glm::dvec3 area(0);
    const glm::dvec3 origin = corners[0];
    for (std::size_t i = 0; i < corners.size(); ++i)
        area += glm::cross(corners[i] - origin, corners[(i + 1) % corners.size()] - origin);
    int drop = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(area[axis]) > std::abs(area[drop])) drop = axis;
    int u = (drop + 1) % 3, v = (drop + 2) % 3;
    if (area[drop] < 0) std::swap(u, v);
    Points flat;
    for (const glm::dvec3& p : corners) flat.emplace_back((p - origin)[u], (p - origin)[v]);
    return flat;
}

/// The polygon that is left, as a ring of corner numbers.
class Ring {
public:
    explicit Ring(const Points& points) : points_(points), next_(points.size()), previous_(points.size()), is_reflex_(points.size()) {
        const std::size_t n = points.size();
        for (std::size_t i = 0; i < n; ++i) {
            next_[i] = static_cast<std::uint32_t>((i + 1) % n);
            previous_[i] = static_cast<std::uint32_t>((i + n - 1) % n);
        }
        for (std::uint32_t i = 0; i < n; ++i) is_reflex_[i] = bend(i) <= 0;
        for (std::uint32_t i = 0; i < n; ++i)
            if (is_reflex_[i]) reflex_.push_back(i);
    }

    std::uint32_t next(std::uint32_t i) const { return next_[i]; }
    std::uint32_t previous(std::uint32_t i) const { return previous_[i]; }

    /// Convex, and no reflex or straight corner lies in the triangle that would go.
    bool is_ear(std::uint32_t i) const {
        const glm::dvec2 a = points_[previous_[i]], b = points_[i], c = points_[next_[i]];
        if (!(turn(a, b, c) > 0)) return false;
        for (const std::uint32_t r : reflex_) {
            const glm::dvec2 p = points_[r];
            // Other corners at the same place touch (bridges to holes do that); they do not block.
            if (!is_reflex_[r] || p == a || p == b || p == c) continue;
            if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
        }
        return true;
    }

    void remove(std::uint32_t i) {
        next_[previous_[i]] = next_[i];
        previous_[next_[i]] = previous_[i];
        is_reflex_[i] = false;
        // Cutting an ear only opens the corners beside it: a convex corner stays convex.
        for (const std::uint32_t side : {previous_[i], next_[i]})
            if (is_reflex_[side]) is_reflex_[side] = bend(side) <= 0;
        if (++removed_ % 64 == 0) std::erase_if(reflex_, [&](std::uint32_t r) { return !is_reflex_[r]; });
    }

private:
    double bend(std::uint32_t i) const { return turn(points_[previous_[i]], points_[i], points_[next_[i]]); }

    const Points& points_;
    std::vector<std::uint32_t> next_, previous_;
    std::vector<bool> is_reflex_;
    std::vector<std::uint32_t> reflex_;
    std::size_t removed_ = 0;
};

} // namespace

void triangulate(std::span<const glm::dvec3> corners, std::vector<std::array<std::uint32_t, 3>>& out) {
    if (corners.size() == 3) return out.push_back({0, 1, 2});
    const Points points = flatten(corners);
    Ring ring(points);
    std::uint32_t at = 1;  // quads split from corner 0 to corner 2, as is the custom
    for (std::size_t left = corners.size(); left > 3; --left) {
        std::uint32_t ear = at;
        for (std::size_t tried = 0; tried < left && !ring.is_ear(ear); ++tried) ear = ring.next(ear);
        out.push_back({ring.previous(ear), ear, ring.next(ear)});
        // Going on beyond the next corner keeps a round polygon from becoming a fan of slivers.
        at = ring.next(ring.next(ear));
        ring.remove(ear);
    }
    out.push_back({ring.previous(at), at, ring.next(at)});
}

} // namespace rayclock
