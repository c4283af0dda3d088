// Haines' "gears": n^3 interlocked gears, each a closed prism over a 144-gon with 36 teeth.
//
// The 144-gon is not convex. It is cut into the 36 teeth, four corners each, and the convex 72-gon between
// them. The 72-gon is halved again and again, because a fan would give long thin triangles, which suit a
// bounding-volume hierarchy badly. All diagonals run from corner to corner, so top, bottom and sides meet
// without T-junctions.
#include "model/scene/generate/generate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <glm/gtc/matrix_transform.hpp>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

constexpr std::uint32_t teeth = 36, corners = 4 * teeth, inner = 2 * teeth;
constexpr int triangles_per_gear = 2 * (corners - 2) + 2 * corners;

struct GearShape {
    double spacing, outer, inner, thickness;
    explicit GearShape(int n)
        : spacing(1 / (n - 0.05 * (n - 1))),
          outer(0.995 * spacing),
          inner(0.9 * spacing),
          thickness(std::min(0.1, 0.5 / n)) {}
};

/// Returns a corner of the outline, tooth by tooth: two on the tooth, two at its foot.
glm::dvec3 outline(const GearShape& shape, double phase, std::uint32_t corner) {
    constexpr double tooth = 2 * std::numbers::pi / teeth;
    constexpr std::array<double, 4> offset{-0.19, 0.19, 0.3, 0.7};
    const double angle = phase + corner / 4 * tooth + offset[corner % 4] * tooth;
    const double radius = corner % 4 < 2 ? shape.outer : shape.inner;
    return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

/// Returns corner i of the 72-gon between the teeth.
std::uint32_t foot(std::uint32_t i) { return i / 2 * 4 + 2 + i % 2; }

/// Cuts the part of the 72-gon between its corners `from` and `to`; `to` may be `inner`, which means 0.
template <class Emit> void halve(std::uint32_t from, std::uint32_t to, const Emit& emit) {
    if (to - from < 2) return;
    const std::uint32_t middle = (from + to) / 2;
    emit(foot(from), foot(middle), foot(to % inner));
    halve(from, middle, emit);
    halve(middle, to, emit);
}

/// Cuts the outline into its 142 triangles, counter-clockwise seen from above.
template <class Emit> void cut_outline(const Emit& emit) {
    for (std::uint32_t p = 0; p < corners; p += 4) {
        const std::uint32_t before = (p + corners - 1) % corners;
        emit(before, p, p + 1);
        emit(p + 1, p + 2, before);
    }
    emit(foot(0), foot(inner / 3), foot(2 * inner / 3));
    for (std::uint32_t third = 0; third < 3; ++third) halve(third * inner / 3, (third + 1) * inner / 3, emit);
}

void gear(MeshWriter& mesh, const GearShape& shape, const glm::dvec3& centre, double phase) {
    const glm::dvec3 down(0, 0, -shape.thickness);
    const std::uint32_t top = mesh.vertex(centre + outline(shape, phase, 0)), bottom = top + corners;
    for (std::uint32_t i = 1; i < corners; ++i) mesh.vertex(centre + outline(shape, phase, i));
    for (std::uint32_t i = 0; i < corners; ++i) mesh.vertex(centre + outline(shape, phase, i) + down);
    cut_outline(
        [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh.triangle(top + a, top + b, top + c); });
    for (std::uint32_t e = 0; e < corners; ++e) {
        const std::uint32_t next = (e + 1) % corners;
        mesh.triangle(top + e, bottom + e, bottom + next);
        mesh.triangle(bottom + next, top + next, top + e);
    }
    cut_outline([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangle(bottom + c, bottom + b, bottom + a);
    });
}

Material gear_material(int x, int y, int z) {
    const auto component = [](int number) { return 0.01 + number % 7 / 7.0; };
    const glm::dvec3 q(component(5 * (3 * x + 2 * y + z + 1)), component(3 * (3 * y + 2 * z + x + 1)),
                       component(2 * (3 * z + 2 * x + y + 1)));
    Material material{.name =
                          "gear " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z)};
    material.colour = q / std::max({q.x, q.y, q.z});
    const bool is_clear = (4 * x + 2 * y + z) % 5 == 0;
    material.ambient = is_clear ? 0.2 : 0.1;
    material.diffuse = is_clear ? 0.2 : 0.5;
    material.transmit = is_clear ? 0.8 : 0;
    material.index = is_clear ? 1.1 : 1;
    return material;
}

/// Writes camera, lights and ground, and reserves room for more vertices and triangles.
MeshWriter begin_gears(Scene& scene, std::uint64_t vertices, std::uint64_t triangles) {
    scene.camera = Camera{{-1.1, -2.1, 2.6}, {0, 0, 0}, {0, 0, 1}, 45};
    scene.lights =
        white_lights({{2, 4, 4}, {-2, 4, 3}, {2, -2.5, 2.5}, {-1, -4, 2}, {-1.111, -2.121, 2.626}});
    MeshWriter mesh(scene);
    mesh.reserve(vertices + 4, {.triangles = triangles + 2}, false);
    mesh.material({.name = "ground",
                   .colour{1, 0.85, 0.7},
                   .ambient = 0.15,
                   .diffuse = 0.3,
                   .highlight = 0.3,
                   .shine = shine_of(37),
                   .mirror = 0.6});
    const std::uint32_t ground = mesh.vertex({2, 2, 0});
    for (const glm::dvec3& corner : {glm::dvec3(-2, 2, 0), {-2, -2, 0}, {2, -2, 0}}) mesh.vertex(corner);
    mesh.triangle(ground, ground + 1, ground + 2);
    mesh.triangle(ground + 2, ground + 3, ground);
    return mesh;
}

/// Returns a gear about the origin.
SharedMesh one_gear(const GearShape& shape) {
    Scene alone;
    MeshWriter writer(alone);
    writer.reserve(2 * corners, {.triangles = triangles_per_gear}, false);
    gear(writer, shape, glm::dvec3(0), 0);
    return {"gear", std::move(alone.vertices), {}, std::move(alone.triangles)};
}

/// Calls `see` for each gear with its centre, its rotation and its material.
template <class See> void each_gear(int size, const GearShape& shape, const See& see) {
    for (int z = 0; z < size; ++z)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const double r = shape.spacing;
                const glm::dvec3 centre(-1 + r + 1.9 * r * x, -1 + r + 1.9 * r * y,
                                        1 - static_cast<double>(z) / size);
                see(centre, std::numbers::pi / 36 * ((x + y + z) % 2), gear_material(x, y, z));
            }
}

}   // namespace

std::uint64_t gears_triangles(int size) {
    const auto n = static_cast<std::uint64_t>(size);
    return n * n * n * triangles_per_gear + 2;
}

Scene make_gears(int size) {
    Scene scene;
    const std::uint64_t triangles = gears_triangles(size) - 2;
    MeshWriter mesh = begin_gears(scene, triangles / triangles_per_gear * 2 * corners, triangles);
    const GearShape shape(size);
    each_gear(size, shape, [&](const glm::dvec3& centre, double phase, const Material& material) {
        mesh.material(material);
        gear(mesh, shape, centre, phase);
    });
    return scene;
}

std::uint64_t clockwork_triangles(int size) {
    const auto n = static_cast<std::uint64_t>(size);
    return n * n * triangles_per_gear + 2;
}

PlacedScene make_clockwork(int size) {
    PlacedScene scene;
    begin_gears(scene.own, 0, 0);
    const GearShape shape(size);
    scene.meshes.push_back(one_gear(shape));
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double r = shape.spacing, sense = (x + y) % 2 == 0 ? 1 : -1;
            const auto number = static_cast<std::uint32_t>(scene.instances.size());
            MotionNode node{.name = "gear " + std::to_string(x) + " " + std::to_string(y)};
            node.is_parts = true;
            node.translate = {-1 + r + 1.9 * r * x, -1 + r + 1.9 * r * y, 0.8};
            for (int quarter = 0; quarter <= 4; ++quarter) {   // one turn in four seconds
                node.rotations.times.push_back(quarter);
                node.rotations.values.push_back(glm::angleAxis(
                    std::numbers::pi / 36 * ((x + y) % 2) + sense * std::numbers::pi / 2 * quarter,
                    glm::dvec3(0, 0, 1)));
            }
            scene.instances.push_back({node.name, 0, glm::dmat4(1), number + 1});   // 0 is the ground
            scene.own.materials.push_back(gear_material(x, y, 0));
            scene.motion.attached.push_back({number, number, glm::dmat4(1)});
            scene.motion.nodes.push_back(std::move(node));
        }
    pose(scene, 0);
    return scene;
}

PlacedScene make_gearbox(int size) {
    PlacedScene scene;
    begin_gears(scene.own, 0, 0);
    const GearShape shape(size);
    scene.meshes.push_back(one_gear(shape));
    each_gear(size, shape, [&](const glm::dvec3& centre, double phase, Material material) {
        const glm::dmat4 place = glm::rotate(glm::translate(glm::dmat4(1), centre), phase, {0, 0, 1});
        scene.instances.push_back(
            {material.name, 0, place, static_cast<std::uint32_t>(scene.own.materials.size())});
        scene.own.materials.push_back(std::move(material));
    });
    return scene;
}

}   // namespace rayclock
