// Haines' "balls": the sphereflake. Every sphere has nine spheres of a third its size around it.
#include "model/scene/generate/generate.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

using Offsets = std::array<glm::dvec3, 9>;

/// Returns the directions of the children of a parent that stands on e_z: three tilted up and six on the
/// equator.
Offsets child_directions() {
    Offsets offsets;
    constexpr double degree = std::numbers::pi / 180;
    for (std::size_t i = 0; i < 3; ++i) {
        const double turn = 120 * degree * static_cast<double>(i);
        const auto around = [&](double degrees) {
            return glm::dvec3(std::cos(degrees * degree + turn), std::sin(degrees * degree + turn), 0);
        };
        offsets[3 * i] = std::sqrt(1.0 / 3) * around(45) + glm::dvec3(0, 0, std::sqrt(2.0 / 3));
        offsets[3 * i + 1] = around(15);
        offsets[3 * i + 2] = around(75);
    }
    return offsets;
}

/// Returns a rotation that takes e_z to the unit vector u. The poles occur, up to rounding, and fix the
/// azimuth of the children there.
glm::dmat3 turned_to(const glm::dvec3& u) {
    if (u.z >= 0.9999) return glm::dmat3(1);
    if (u.z <= -0.9999) return glm::dmat3({-1, 0, 0}, {0, 1, 0}, {0, 0, -1});
    const glm::dvec3 axis = unit({-u.y, u.x, 0});
    const double c = u.z, s = std::sqrt(1 - c * c);
    glm::dmat3 turn;
    for (int column = 0; column < 3; ++column) {
        glm::dvec3 e(0);
        e[column] = 1;
        turn[column] = e * c + glm::cross(axis, e) * s + axis * (axis[column] * (1 - c));
    }
    return turn;
}

/// Calls `use` with the centre and the radius of every ball.
template <class Use> void each_ball(const Offsets& offsets, int depth, const glm::dvec3& centre,
                                    double radius, const glm::dvec3& up, const Use& use) {
    use(centre, radius);
    if (depth == 0) return;
    const glm::dmat3 turn = turned_to(up);
    for (const glm::dvec3& offset : offsets) {
        const glm::dvec3 direction = turn * offset;
        each_ball(offsets, depth - 1, centre + 4.0 / 3 * radius * direction, radius / 3, direction, use);
    }
}
template <class Use> void each_ball(int size, const Use& use) {
    each_ball(child_directions(), size, glm::dvec3(0), 0.5, {0, 0, 1}, use);
}

std::uint64_t sphere_count(int size) {
    std::uint64_t nine_to_the = 9;
    for (int i = 0; i < size; ++i) nine_to_the *= 9;
    return (nine_to_the - 1) / 8;
}

constexpr std::uint32_t ball_material = 1;   // the floor has material 0

/// Writes camera, lights and floor, and sets the balls' material.
void begin_balls(Scene& scene, MeshWriter& mesh) {
    scene.camera = Camera{{2.1, 1.3, 1.7}, {0, 0, 0}, {0, 0, 1}, 45};
    scene.lights = white_lights({{4, 3, 2}, {1, -4, 4}, {-3, 1, 5}});
    mesh.material({.name = "floor", .colour{1, 0.75, 0.33}, .ambient = 0.2, .diffuse = 0.4});
    mesh.flat({{12, 12, -0.5}, {-12, 12, -0.5}, {-12, -12, -0.5}, {12, -12, -0.5}});
    mesh.material({.name = "balls",
                   .colour{1, 0.9, 0.7},
                   .ambient = 0.15,
                   .diffuse = 0.5,
                   .highlight = 0.5,
                   .shine = shine_of(37),
                   .mirror = 0.5});
}

}   // namespace

PrimitiveCounts balls_counts(int size, Primitives primitives) {
    if (primitives == Primitives::native) return {.triangles = 2, .spheres = sphere_count(size)};
    return {.triangles = sphere_count(size) * sphere_triangles + 2};
}

Scene make_balls(int size, Primitives primitives) {
    const bool is_cut = primitives == Primitives::triangles;
    Scene scene;
    MeshWriter mesh(scene, primitives);
    mesh.reserve((is_cut ? sphere_count(size) * sphere_vertices : 0) + 4, balls_counts(size, primitives),
                 is_cut);
    begin_balls(scene, mesh);
    each_ball(size, [&](const glm::dvec3& centre, double radius) { mesh.sphere(centre, radius); });
    return scene;
}

std::uint64_t flake_triangles(int size) { return balls_counts(size, Primitives::triangles).triangles; }

PlacedScene make_flake(int size) {
    PlacedScene scene;
    MeshWriter mesh(scene.own);
    begin_balls(scene.own, mesh);
    scene.meshes.push_back(ball_mesh(ball_material));
    each_ball(size, [&](const glm::dvec3& centre, double radius) {
        scene.instances.push_back(ball_at(centre, radius, 0));
    });
    return scene;
}

}   // namespace rayclock
