#pragma once
// An independent judge: Moeller, Trumbore 1997 in long double, without hierarchy and early exit.
#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "model/scene/scene.hpp"

namespace rayclock {

using Exact3 = glm::vec<3, long double>;

/// A ray's crossing of one triangle's plane. `inside` is the smallest barycentric weight: >= 0 means inside.
struct PlaneHit {
    bool crosses = false;    ///< false for degenerate triangles and rays parallel to the plane
    long double depth = 0;   ///< along the unit direction
    long double u = 0, v = 0;
    long double inside = -1;
    long double cosine = 0;   ///< |cos| of the angle between ray and normal
};

inline PlaneHit plane_hit(const Scene& scene, std::uint32_t primitive, const glm::dvec3& origin,
                          const glm::dvec3& direction) {
    const auto& vertex = scene.triangles[primitive].vertex;
    const Exact3 a(scene.vertices[vertex[0]]), b(scene.vertices[vertex[1]]), c(scene.vertices[vertex[2]]);
    const Exact3 d = glm::normalize(Exact3(direction)), e1 = b - a, e2 = c - a;
    const Exact3 p = glm::cross(d, e2), s = Exact3(origin) - a, q = glm::cross(s, e1);
    const long double det = glm::dot(e1, p), doubled_area = glm::length(glm::cross(e1, e2));
    PlaneHit hit;
    if (!(std::abs(det) > 0)) return hit;
    hit.crosses = true;
    hit.depth = glm::dot(e2, q) / det;
    hit.u = glm::dot(s, p) / det;
    hit.v = glm::dot(d, q) / det;
    hit.inside = std::min({hit.u, hit.v, 1 - hit.u - hit.v});
    hit.cosine = std::abs(det) / doubled_area;
    return hit;
}

/// Returns the smallest distance between the ray's line and the segment a-b.
inline long double distance_to_segment(const Exact3& origin, const Exact3& unit, const Exact3& a,
                                       const Exact3& b) {
    // Projected along the ray: the line is the point 0, the segment is flat.
    const auto flat = [&](const Exact3& p) { return p - origin - glm::dot(p - origin, unit) * unit; };
    const Exact3 from = flat(a), along = flat(b) - from;
    const long double length2 = glm::dot(along, along);
    const long double t = length2 > 0 ? std::clamp(-glm::dot(from, along) / length2, 0.0L, 1.0L) : 0.0L;
    return glm::length(from + t * along);
}

/// Returns the distance of the ray's line from the nearest of the triangle's three edges.
inline long double distance_to_edges(const Scene& scene, std::uint32_t primitive, const glm::dvec3& origin,
                                     const glm::dvec3& direction) {
    const auto& vertex = scene.triangles[primitive].vertex;
    const Exact3 o(origin), d = glm::normalize(Exact3(direction));
    long double least = std::numeric_limits<long double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const Exact3 a(scene.vertices[vertex[i]]), b(scene.vertices[vertex[(i + 1) % 3]]);
        least = std::min(least, distance_to_segment(o, d, a, b));
    }
    return least;
}

}   // namespace rayclock
