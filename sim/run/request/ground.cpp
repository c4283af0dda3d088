// The position of the ground, and its triangles.
#include "sim/run/request/ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace rayclock {

namespace {

/// Returns the scene's lowest coordinate along `up`. Infinite for a scene without triangles and spheres.
double lowest(const Scene& scene, const glm::dvec3& up) {
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : scene.triangles)
        for (const std::uint32_t v : triangle.vertex)
            least = std::min(least, glm::dot(scene.vertices[v], up));
    for (const Sphere& sphere : scene.spheres)
        least = std::min(least, glm::dot(sphere.centre, up) - sphere.radius);
    return least;
}

/// Returns a unit vector at right angles to `up`.
glm::dvec3 across(const glm::dvec3& up) {
    const glm::dvec3 size = glm::abs(up);
    const int least = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
    glm::dvec3 axis{0};
    axis[least] = 1;
    return glm::normalize(glm::cross(up, axis));
}

}   // namespace

void lay_ground(Scene& scene) {
    const glm::dvec3 up = glm::normalize(scene.camera->up), s = across(up), t = glm::cross(up, s);
    const Bounds box = bounds(scene);
    const glm::dvec3 middle = 0.5 * (box.lo + box.hi);
    const double reach = 0.5 * glm::length(box.hi - box.lo), least = lowest(scene, up);
    const double height = std::isfinite(least) ? least - 1e-3 * reach : glm::dot(middle, up);
    const glm::dvec3 centre = middle + (height - glm::dot(middle, up)) * up;

    const auto first = std::uint32_t(scene.vertices.size()), material = std::uint32_t(scene.materials.size());
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        scene.vertices.push_back(centre + 4 * reach * (double(x) * s + double(y) * t));
        if (!scene.normals.empty()) scene.normals.push_back(up);
    }
    scene.triangles.push_back({{first, first + 1, first + 2}, material});
    scene.triangles.push_back({{first, first + 2, first + 3}, material});
    if (!scene.coordinates.empty()) scene.coordinates.resize(scene.triangles.size());   // without a texture
    Material grey;
    grey.name = "ground";
    grey.colour = glm::dvec3{0.5};
    scene.materials.push_back(grey);
}

}   // namespace rayclock
