#pragma once
// Instances with mirrors, glass and shadows, for the tests of finished pictures in two levels.
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "model/scene/placed.hpp"

namespace rayclock {

/// Returns a ball of radius 1; normals point outwards if it is smooth.
inline SharedMesh ball(bool is_smooth) {
    const Scene scene = make_builtin("icosphere:3");
    SharedMesh mesh{"ball", scene.vertices, {}, scene.triangles};
    for (Triangle& triangle : mesh.triangles) triangle.material = 1;
    if (is_smooth) mesh.normals = mesh.vertices;
    return mesh;
}

inline Material coloured(const glm::dvec3& colour, double mirror, double transmit) {
    Material material;
    material.colour = colour, material.mirror = mirror, material.transmit = transmit;
    material.highlight = 0.3, material.shine = 20;
    if (transmit > 0) material.index = 1.3;
    return material;
}

/// Returns balls on a floor: rotated, squeezed, mirrored, small, and of glass, with two lights.
inline PlacedScene mixed(bool is_smooth) {
    PlacedScene scene;
    Scene& own = scene.own;
    own.name = "mixed";
    own.materials = {coloured({0.5, 0.6, 0.5}, 0.1, 0), coloured({0.8, 0.2, 0.2}, 0.2, 0),
                     coloured({0.3, 0.3, 0.4}, 0.6, 0), coloured({0.1, 0.2, 0.1}, 0.1, 0.7)};
    own.vertices = {{-8, -1, -8}, {-8, -1, 8}, {8, -1, 8}, {8, -1, -8}};
    if (is_smooth) own.normals.assign(4, {0, 1, 0});
    own.triangles = {{{0, 1, 2}, 0}, {{0, 2, 3}, 0}};
    own.lights = {{{6, 9, 4}, glm::dvec3(0.7)}, {{-5, 7, 7}, {0.4, 0.4, 0.3}}};
    own.camera = Camera{{3, 4, 9}, {0, 0, 0}, {0, 1, 0}, 45};
    scene.meshes.push_back(ball(is_smooth));
    const auto put = [&](const glm::dvec3& at, double angle, const glm::dvec3& axis, const glm::dvec3& size,
                         std::optional<std::uint32_t> material) {
        glm::dmat4 place = glm::rotate(glm::translate(glm::dmat4(1), at), angle, axis);
        scene.instances.push_back({"ball", 0, glm::scale(place, size), material});
    };
    put({-2.5, 0, 0}, 0, {0, 1, 0}, glm::dvec3(1), {});
    put({0, 0, -1}, 0, {0, 1, 0}, glm::dvec3(1), 2);
    put({2.5, -0.2, 0.5}, 0.7, {0.6, 0.8, 0}, {1.2, 0.5, 0.8}, {});
    put({0.3, -0.4, 1.8}, 0, {0, 1, 0}, {-0.6, 0.6, 0.6}, 3);
    put({-1.6, -0.7, 2}, 0, {0, 1, 0}, glm::dvec3(0.3), 2);
    put({1.8, -0.6, 2.2}, 0.4, {0, 0, 1}, {0.3, 0.3, -0.6}, 1);
    return scene;
}

/// Returns the same on a checkered plane, with two true spheres, one of glass.
inline PlacedScene mixed_with_round(bool is_smooth) {
    PlacedScene scene = mixed(is_smooth);
    Scene& own = scene.own;
    own.vertices.clear(), own.normals.clear(), own.triangles.clear();
    own.materials[0].checkered = true;
    own.planes = {{{0.2, -1, 0.1}, {1.3, 0, 0}, {0, 0, -1.3}, 0}};
    own.spheres = {{{-0.9, -0.6, 2.9}, 0.4, 3}, {{1.4, 0.9, -0.4}, 0.5, 2}};
    return scene;
}

/// Returns balls under a pane of glass that is seen at a grazing angle, with corner normals that lean away
/// from the camera. Its refracted directions have about a quarter of the usual length.
inline PlacedScene under_a_pane() {
    PlacedScene scene = mixed(true);
    scene.own.camera = Camera{{0, 1, 9}, {0, 0, 0}, {0, 1, 0}, 60};
    Material glass = coloured({0.1, 0.1, 0.1}, 0.1, 0.8);
    glass.index = std::sqrt(2.0);
    scene.own.materials.push_back(glass);
    SharedMesh pane{"pane", {{-4, 0, -2}, {-4, 0, 5}, {4, 0, 5}, {4, 0, -2}}, {}, {}};
    pane.normals.assign(4, glm::normalize(glm::dvec3(0, 0.2, -1)));
    pane.triangles = {{{0, 1, 2}, 4}, {{0, 2, 3}, 4}};
    scene.meshes.push_back(pane);
    scene.instances.push_back({"pane", 1, glm::translate(glm::dmat4(1), glm::dvec3(0, 0.3, 0)), {}});
    return scene;
}

}   // namespace rayclock
