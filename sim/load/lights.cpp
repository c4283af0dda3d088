// Placement of the key light and the fill light.
#include "sim/load/lights.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace rayclock {

void add_missing_lights(Scene& scene) {
    if (!scene.lights.empty()) return;
    const Bounds box = bounds(scene);
    const Camera camera = scene.camera ? *scene.camera : fit_camera(scene, 4.0 / 3.0);
    const glm::dvec3 forward = glm::normalize(camera.at - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    // A camera inside the scene (a room) has its lights close by. A camera outside has them outside too.
    const double size = glm::length(box.hi - box.lo);
    const bool is_inside =
        glm::all(glm::greaterThan(camera.eye, box.lo)) && glm::all(glm::lessThan(camera.eye, box.hi));
    const double step = (is_inside ? 0.05 : 0.5) * size;
    scene.lights.push_back({camera.eye + step * (right + up), glm::dvec3(0.9)});
    scene.lights.push_back({camera.eye + step * (0.25 * up - 1.5 * right), glm::dvec3(0.25)});
}

}   // namespace rayclock
