#pragma once
// Explains differences between Embree and an exact tracer by Embree's rounding.
#include "model/scene/hit.hpp"
#include "tests/reference/oracle.hpp"

namespace rayclock {

/// Returns the largest error of Embree's view of a ray and a triangle, as a length in the scene. d is the
/// distance of the triangle's farthest corner. One rounding is 2^-24 relative. Origin and vertices are
/// rounded once (o and o + d), the direction once (d). Then its Pluecker test translates, subtracts vertices
/// and sums three products of differences: about 8 roundings of at most d. Twice the sum leaves room.
inline long double embree_error(const Scene& scene, std::uint32_t primitive, const glm::dvec3& origin) {
    long double d = 0;
    for (const std::uint32_t v : scene.triangles[primitive].vertex)
        d = std::max<long double>(d, glm::length(scene.vertices[v] - origin));
    const long double o = glm::length(origin);
    return 2 * 0x1p-24L * (o + (o + d) + d + 8 * d);
}

/// A ray in a scene, and the judge of two answers to it.
struct EmbreeJudge {
    const Scene& scene;
    glm::dvec3 origin, direction;
    PlaneHit plane(std::uint32_t primitive) const { return plane_hit(scene, primitive, origin, direction); }

    /// Returns true if the ray passes so close to an edge of the triangle that Embree cannot decide the side.
    bool at_edge(std::uint32_t primitive) const {
        return distance_to_edges(scene, primitive, origin, direction) <=
               embree_error(scene, primitive, origin);
    }
    /// A shift across the ray changes the plane's depth by the tangent of its slope.
    long double depth_error(std::uint32_t primitive) const {
        return embree_error(scene, primitive, origin) / plane(primitive).cosine;
    }

    /// Returns true if rounding explains the difference. Either the depths are equal within rounding and one
    /// triangle is met or nearly met. Or the nearer one is met or missed only by rounding at its edge.
    bool explains(std::uint32_t ours, std::uint32_t theirs) const {
        if (ours == no_primitive || theirs == no_primitive)
            return at_edge(ours == no_primitive ? theirs : ours);
        const PlaneHit a = plane(ours), b = plane(theirs);
        const bool a_met = a.crosses && (a.inside >= 0 || at_edge(ours));
        const bool b_met = b.crosses && (b.inside >= 0 || at_edge(theirs));
        if (a_met && b_met && std::abs(a.depth - b.depth) <= depth_error(ours) + depth_error(theirs))
            return true;
        return at_edge(a.depth < b.depth ? ours : theirs);
    }
};

}   // namespace rayclock
