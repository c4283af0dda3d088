#pragma once
// Closed meshes in random places, for the tests of two levels.
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "model/core/config.hpp"
#include "model/engine/check.hpp"
#include "model/scene/placed.hpp"
#include "tests/support/machine/structures.hpp"
#include "tests/support/scenes/hard_meshes.hpp"

namespace rayclock {

inline Config format(int coord_bits, int dir_bits) {
    Config config;
    config.coord_bits = coord_bits;
    config.dir_bits = dir_bits;
    config.stack_depth = 64;
    check_config(config, "the test");
    return config;
}

/// Planes in any direction need two free bits in the line of a node.
inline Config of_structure(Config config, Structure structure) {
    config.structure = structure;
    if (config.is_walked(Structure::bsp)) config.addr_bits = 22;
    return config;
}

inline glm::dmat4 random_map(Draw& draw, double least_scale, double most_scale, double shear) {
    glm::dmat4 m = glm::translate(glm::dmat4(1), 4.0 * draw.point());
    m = glm::rotate(m, 3.2 * draw(), glm::normalize(draw.point() + glm::dvec3(0, 0, 1e-3)));
    const auto scale = [&] {
        const double size = least_scale * std::pow(most_scale / least_scale, 0.5 + 0.5 * draw());
        return draw() < 0 ? -size : size;
    };
    glm::dmat4 sheared(1);
    sheared[1][0] = shear * draw(), sheared[2][0] = shear * draw(), sheared[2][1] = shear * draw();
    m = m * sheared * glm::scale(glm::dmat4(1), glm::dvec3(scale(), scale(), scale()));
    return glm::rotate(m, 3.2 * draw(), glm::dvec3(0, 1, 0));
}

inline SharedMesh cube() {
    SharedMesh mesh{"cube", {}, {}, {}};
    for (std::uint32_t i = 0; i < 8; ++i) mesh.vertices.push_back({i & 1, i >> 1 & 1, i >> 2});
    const std::array<std::array<std::uint32_t, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [p, q, r, t] : sides) {
        mesh.triangles.push_back({{p, q, r}, 0});
        mesh.triangles.push_back({{p, r, t}, 0});
    }
    return mesh;
}

/// Returns balls and cubes alternately, in random places.
inline PlacedScene solids(int count, std::uint32_t seed, double least, double most, double shear) {
    Draw draw{seed};
    PlacedScene scene = make_placed("icosphere:2");
    scene.meshes.push_back({"ball", scene.own.vertices, {}, scene.own.triangles});
    scene.meshes.push_back(cube());
    scene.own.vertices.clear(), scene.own.normals.clear(), scene.own.triangles.clear();
    for (int i = 0; i < count; ++i)
        scene.instances.push_back({"solid", std::uint32_t(i % 2), random_map(draw, least, most, shear), {}});
    return scene;
}

}   // namespace rayclock
