// Bridges between the outline of a polygon and its holes, in the plane of two coordinates.
#include "sim/load/holes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace rayclock {
namespace {

/// Returns twice the signed area of a triangle.
double twice_area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

glm::dvec3 area_vector(const std::vector<Corner>& ring) {
    glm::dvec3 area(0);
    for (std::size_t i = 0; i < ring.size(); ++i)
        area += glm::cross(ring[i].position - ring[0].position,
                           ring[(i + 1) % ring.size()].position - ring[0].position);
    return area;
}

/// Projects the outline along the axis of its largest area component, so that it runs counter-clockwise.
class Outline {
public:
    explicit Outline(const std::vector<Corner>& outline) {
        const glm::dvec3 area = area_vector(outline);
        int drop = 0;
        for (int axis = 1; axis < 3; ++axis)
            if (std::abs(area[axis]) > std::abs(area[drop])) drop = axis;
        u_ = (drop + 1) % 3, v_ = (drop + 2) % 3;
        if (area[drop] < 0) std::swap(u_, v_);
    }
    glm::dvec2 operator()(const Corner& c) const { return {c.position[u_], c.position[v_]}; }
    double area(const std::vector<Corner>& ring) const {
        double sum = 0;
        for (std::size_t i = 1; i + 1 < ring.size(); ++i)
            sum += twice_area((*this)(ring[0]), (*this)(ring[i]), (*this)(ring[i + 1]));
        return sum;
    }

private:
    int u_ = 0, v_ = 1;
};

/// Returns a corner of a counter-clockwise ring that is visible from the point `from` inside it. It is the
/// end of the first edge to the right, or a reflex corner in the triangle between the two.
std::size_t seen_from(glm::dvec2 from, const std::vector<glm::dvec2>& ring) {
    const std::size_t n = ring.size();
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t seen = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        const glm::dvec2 a = ring[i], b = ring[next];
        if (!(a.y <= from.y && from.y <= b.y) || a.y == b.y) continue;   // edges upward bound the right side
        const double x = a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x);
        if (x < from.x || x >= nearest) continue;
        nearest = x;
        seen = from.y == a.y || (from.y != b.y && a.x > b.x) ? i : next;
    }
    if (!std::isfinite(nearest)) return 0;
    const glm::dvec2 target = ring[seen], hit(nearest, from.y);
    const bool is_above = target.y > from.y;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 p = ring[i], before = ring[(i + n - 1) % n], after = ring[(i + 1) % n];
        if (twice_area(before, p, after) > 0 || p == target || p.x < from.x) continue;
        const double side = is_above ? 1 : -1;
        if (side * twice_area(from, hit, p) < 0 || side * twice_area(hit, target, p) < 0 ||
            side * twice_area(target, from, p) < 0)
            continue;
        // Bridges give one place several corners: the bridge must start inside this corner's angle.
        if (!(twice_area(before, p, from) > 0 || twice_area(p, after, from) > 0)) continue;
        const double slope = std::abs(p.y - from.y) / (p.x - from.x);
        if (slope >= best) continue;
        best = slope;
        seen = i;
    }
    return seen;
}

}   // namespace

std::vector<Corner> joined_ring(const std::vector<Corner>& outline, std::vector<std::vector<Corner>> holes) {
    const Outline plane(outline);
    const auto rightmost = [&](const std::vector<Corner>& ring) {
        return std::max_element(ring.begin(), ring.end(),
                                [&](const Corner& a, const Corner& b) { return plane(a).x < plane(b).x; });
    };
    for (std::vector<Corner>& hole : holes) {
        if (plane.area(hole) > 0) std::reverse(hole.begin(), hole.end());
        std::rotate(hole.begin(), hole.begin() + (rightmost(hole) - hole.cbegin()), hole.end());
    }
    // From right to left, so that no later hole lies between a hole and its visible corner.
    std::stable_sort(holes.begin(), holes.end(),
                     [&](const auto& a, const auto& b) { return plane(a.front()).x > plane(b.front()).x; });
    std::vector<Corner> ring = outline;
    std::vector<glm::dvec2> flat;
    for (const Corner& corner : ring) flat.push_back(plane(corner));
    for (std::vector<Corner>& hole : holes) {
        const std::size_t seen = seen_from(plane(hole.front()), flat);
        hole.push_back(hole.front());
        hole.push_back(ring[seen]);
        const auto at = static_cast<std::ptrdiff_t>(seen + 1);
        ring.insert(ring.begin() + at, hole.begin(), hole.end());
        std::vector<glm::dvec2> places;
        for (const Corner& corner : hole) places.push_back(plane(corner));
        flat.insert(flat.begin() + at, places.begin(), places.end());
    }
    return ring;
}

}   // namespace rayclock
