// Haines' "rings": chains of six interlocked pentagonal rings of cylinders and spheres.
#include "model/scene/generate/generate.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double thickness = 0.07412;
constexpr int rings_per_group = 6, joints = 5;

using Group = std::array<std::array<glm::dvec3, joints>, rings_per_group>;

/// Returns the joints of the rings of one group. Ring 0 lies in the plane z = 0, and the others hang in it.
Group group_points() {
    Group points;
    const double scale = 1 / (1 + thickness);
    const double alpha = 2 * std::acos(std::cos(pi / 3) / std::sin(pi / 5));
    for (std::size_t k = 0; k < joints; ++k) {
        const double angle = 2 * pi * static_cast<double>(k) / joints;
        const double x = scale * std::cos(angle), y = scale * std::sin(angle);
        points[0][k] = {x, y, 0};
        for (std::size_t m = 1; m < rings_per_group; ++m) {
            const double turn = pi * (2 * static_cast<double>(m) - 1) / 5, tilted = y * std::cos(alpha);
            points[m][k] = {x * std::cos(turn) - tilted * std::sin(turn),
                            x * std::sin(turn) + tilted * std::cos(turn), y * std::sin(alpha)};
        }
    }
    return points;
}

std::uint64_t links(int size) {
    const auto n = static_cast<std::uint64_t>(size);
    return 5 * n * (n + 1) * (2 * n + 1);
}

void wall(MeshWriter& mesh, int size, double spacing) {
    const double y = spacing * (size + 1), w = 1.01 * (y + spacing) * std::tan(pi / 8);
    mesh.material({.name = "wall", .colour{1, 1, 1}, .ambient = 0.1, .diffuse = 0.5});
    mesh.flat({{w - 1, y, w + 0.5}, {-w - 1, y, w + 0.5}, {-w - 1, y, -w + 0.5}, {w - 1, y, -w + 0.5}});
}

/// The package states a material before every ring. Six are enough; `ring_material` is the first of them.
void group(MeshWriter& mesh, const Group& points, const glm::dvec3& offset, std::uint32_t ring_material) {
    for (std::size_t m = 0; m < rings_per_group; ++m) {
        mesh.use_material(ring_material + static_cast<std::uint32_t>(m));
        for (std::size_t k = 0; k < joints; ++k) {
            const glm::dvec3 base = points[m][k] + offset,
                             apex = points[m][(k + joints - 1) % joints] + offset;
            mesh.cone(base, thickness, apex, thickness);
            mesh.sphere(base, thickness);
        }
    }
}

}   // namespace

PrimitiveCounts rings_counts(int size, Primitives primitives, int sectors) {
    const std::uint64_t all = links(size), cones = all * cone_triangles(sectors);
    if (primitives == Primitives::native) return {.triangles = cones + 2, .spheres = all};
    return {.triangles = all * sphere_triangles + cones + 2};
}

Scene make_rings(int size, Primitives primitives, int sectors) {
    const double spacing = 1 / std::sin(pi / 8);
    Scene scene;
    scene.camera = Camera{{-1, -spacing, 0.5}, {-1, 1 - spacing, 0.5}, {0, 0, 1}, 45};
    scene.lights = white_lights({{3, -spacing, 3}, {-4, -spacing, 1}, {2, -spacing, -4}});
    MeshWriter mesh(scene, primitives, sectors);
    const std::uint64_t vertices =
        (primitives == Primitives::native ? 0 : sphere_vertices) + cone_vertices(sectors);
    mesh.reserve(links(size) * vertices + 4, rings_counts(size, primitives, sectors), true);
    wall(mesh, size, spacing);
    const auto ring_material = static_cast<std::uint32_t>(scene.materials.size());
    constexpr std::array<glm::dvec3, rings_per_group> colours{
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}}};
    for (std::size_t m = 0; m < rings_per_group; ++m)
        mesh.material({.name = "ring " + std::to_string(m),
                       .colour = colours[m],
                       .ambient = 0.15,
                       .diffuse = 0.5,
                       .highlight = 0.3,
                       .shine = shine_of(37),
                       .mirror = 0.2});
    const Group points = group_points();
    for (int d = 0; d < size; ++d)
        for (int j = 0; j <= d; ++j)
            for (int i = 0; i <= d; ++i)
                group(mesh, points, {2 * i - d, spacing * (d + 1), 2 * j - d}, ring_material);
    return scene;
}

}   // namespace rayclock
