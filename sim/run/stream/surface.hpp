#pragma once
// Normals and points of the surfaces of a scene as given.
#include "model/scene/scene.hpp"

namespace rayclock {

/// Returns a vector of any length that points to the front of a primitive at a point on its surface: along
/// (b - a) x (c - a) of a triangle, outward from a sphere, along u x v of a plane.
glm::dvec3 front_normal(const Scene& scene, std::uint32_t primitive, const glm::dvec3& point);

/// Returns the point of a primitive near a point `near` of a ray. For a sphere it is the nearest point, for a
/// triangle or plane the ray's. The ray must not be parallel to the primitive.
glm::dvec3 point_on(const Scene& scene, std::uint32_t primitive, const glm::dvec3& near,
                    const glm::dvec3& direction);

}   // namespace rayclock
