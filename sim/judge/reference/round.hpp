#pragma once
// The reference tracer's tests of a ray against a sphere and against a plane, in its own space. They share
// nothing with the fixed-point machine, and do not snap hits to a lattice: depths are rounded reals.
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "sim/judge/reference/ray.hpp"
#include "sim/judge/reference/unit_space.hpp"

namespace rayclock {

/// A sphere in the tracer's space.
struct RefSphere {
    glm::dvec3 centre{0};
    double radius = 1;
    std::uint32_t primitive = no_primitive;
    bool is_seen_inside = false;   ///< its material transmits
};

/// Computes where a line along a unit direction enters the ball and where it leaves it. Returns false if it
/// misses.
///
/// b^2 - c would cancel for a small or distant ball. So the argument of the root is the squared radius minus
/// the squared distance between centre and line. The second root follows from the product of both (Haines,
/// Gunther, Akenine-Moller 2019, "Precision improvements for ray/sphere intersection").
inline bool ball_roots(const RefSphere& sphere, const glm::dvec3& from, const glm::dvec3& direction,
                       double& enter, double& leave) {
    const glm::dvec3 to_origin = from - sphere.centre;
    const double b = -glm::dot(to_origin, direction);
    const glm::dvec3 across = to_origin + b * direction;
    const double reach = sphere.radius * sphere.radius - glm::dot(across, across);
    if (!(reach >= 0)) return false;
    const double far_root = b + std::copysign(std::sqrt(reach), b);
    const double c = glm::dot(to_origin, to_origin) - sphere.radius * sphere.radius;
    const double other = far_root != 0 ? c / far_root : 0;
    enter = std::min(far_root, other);
    leave = std::max(far_root, other);
    return true;
}

/// Updates `closest`. Of the sphere that a ray leaves, only the far root can be a hit, and only on the
/// inside. So rounding of the near root to slightly above or below 0 does not matter.
inline void test_sphere(const RefSphere& sphere, const RefPath& path, RefClosest& closest) {
    double enter = 0, leave = 0;
    const bool is_left = sphere.primitive == path.left;
    if (is_left && !path.is_inside) return;
    if (!ball_roots(sphere, path.from, path.direction, enter, leave)) return;
    const bool from_inside = is_left || !(enter > 0);
    if (from_inside && !sphere.is_seen_inside) return;
    const double depth = from_inside ? leave : enter;
    if (closest.yields_to(depth, sphere.primitive)) closest = {depth, 0, 0, sphere.primitive};
}

/// A plane in the tracer's space.
struct RefPlane {
    glm::dvec3 point{0}, normal{0};   ///< normal: along u x v, not of unit length
    glm::dvec3 to_u{0}, to_v{0};      ///< products with these count the sides u and v
    std::uint32_t primitive = no_primitive;

    RefPlane(const Plane& plane, const RefUnitSpace& space, std::uint32_t number)
        : point(space(plane.point)), primitive(number) {
        const double u_length = glm::length(plane.u), v_length = glm::length(plane.v);
        const glm::dvec3 u = plane.u / u_length, v = plane.v / v_length;
        normal = glm::cross(u, v);
        const double square = glm::dot(normal, normal);
        to_u = glm::cross(v, normal) / (square * u_length * space.scale);
        to_v = glm::cross(normal, u) / (square * v_length * space.scale);
    }
};

/// Updates `closest`. Both sides are hit. A ray in the plane, or one that starts on it, does not hit it.
inline void test_plane(const RefPlane& plane, const RefPath& path, RefClosest& closest) {
    const double slope = glm::dot(plane.normal, path.direction);
    if (slope == 0 || plane.primitive == path.left) return;
    const double depth = glm::dot(plane.normal, plane.point - path.from) / slope;
    if (!closest.yields_to(depth, plane.primitive) || !std::isfinite(depth)) return;
    const glm::dvec3 along = path.from + depth * path.direction - plane.point;
    closest = {depth, glm::dot(along, plane.to_u), glm::dot(along, plane.to_v), plane.primitive};
}

}   // namespace rayclock
