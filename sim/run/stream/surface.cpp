// Normals and points of surfaces.
#include "sim/run/stream/surface.hpp"

#include <glm/geometric.hpp>

namespace rayclock {

namespace {

/// A flat primitive's point and two vectors within it, or a sphere.
struct Shape {
    glm::dvec3 point{0}, one{0}, other{0};
    const Sphere* sphere = nullptr;
};
Shape shape_of(const Scene& scene, std::size_t primitive) {
    if (primitive < scene.triangles.size()) {
        const auto& corner = scene.triangles[primitive].vertex;
        const glm::dvec3 a = scene.vertices[corner[0]];
        return {a, scene.vertices[corner[1]] - a, scene.vertices[corner[2]] - a};
    }
    primitive -= scene.triangles.size();
    if (primitive < scene.spheres.size()) {
        const Sphere& sphere = scene.spheres[primitive];
        return {sphere.centre, {}, {}, &sphere};
    }
    const Plane& plane = scene.planes[primitive - scene.spheres.size()];
    return {plane.point, plane.u, plane.v};
}

}   // namespace

glm::dvec3 front_normal(const Scene& scene, std::uint32_t primitive, const glm::dvec3& point) {
    const Shape shape = shape_of(scene, primitive);
    return shape.sphere ? point - shape.point : glm::cross(shape.one, shape.other);
}

glm::dvec3 point_on(const Scene& scene, std::uint32_t primitive, const glm::dvec3& near,
                    const glm::dvec3& direction) {
    const Shape shape = shape_of(scene, primitive);
    if (shape.sphere) return shape.point + glm::normalize(near - shape.point) * shape.sphere->radius;
    const glm::dvec3 n = glm::cross(shape.one, shape.other);
    return near + direction * (glm::dot(n, shape.point - near) / glm::dot(n, direction));
}

}   // namespace rayclock
