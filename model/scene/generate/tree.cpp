// Haines' "tree": cones that fork in two, with a sphere at every fork.
#include "model/scene/generate/generate.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/mat3x3.hpp>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

/// Returns kappa R_z(delta) R_x(beta), the frame of a branch in that of its parent.
glm::dmat3 fork(double beta_degrees, double delta_degrees, double kappa) {
    constexpr double degree = std::numbers::pi / 180;
    const double cb = std::cos(beta_degrees * degree), sb = std::sin(beta_degrees * degree);
    const double cd = std::cos(delta_degrees * degree), sd = std::sin(delta_degrees * degree);
    const glm::dmat3 x({1, 0, 0}, {0, cb, sb}, {0, -sb, cb}), z({cd, sd, 0}, {-sd, cd, 0}, {0, 0, 1});
    return kappa * (z * x);
}

using Forks = std::array<glm::dmat3, 2>;
// Ratio of a branch's top radius to its base radius, and of a child's thickness to its parent's.
constexpr double taper = 0.67;

/// Calls `use` with base, base radius, top and top radius of every branch. A ball of the top radius lies on
/// the top.
template <class Use> void each_branch(const Forks& forks, int depth, const glm::dmat3& frame,
                                      const glm::dvec3& base, double thickness, const Use& use) {
    const double base_radius = 0.15 * thickness, top_radius = taper * base_radius;
    const glm::dvec3 top = frame[2] + base;
    use(base, base_radius, top, top_radius);
    if (depth == 0) return;
    for (const glm::dmat3& fork : forks)
        each_branch(forks, depth - 1, frame * fork, top, taper * thickness, use);
}
template <class Use> void each_branch(int size, const Use& use) {
    each_branch({fork(40, 90, 0.65), fork(25, 230, 0.7)}, size, glm::dmat3(1), glm::dvec3(0), 1, use);
}

constexpr std::uint32_t wood = 1;   // material; the field has material 0

/// Writes camera, lights and field, and adds the wood.
void begin_tree(Scene& scene, MeshWriter& mesh) {
    scene.camera = Camera{{4.5, 0.4, 2}, {0, 0, 1.5}, {0, 0, 1}, 45};
    scene.lights = white_lights({{-5, 5, 50},
                                 {30, -30, 30},
                                 {-40, -30, 20},
                                 {10, 30, 40},
                                 {-30, 40, 10},
                                 {50, 25, 20},
                                 {-10, -60, 30}});
    mesh.material({.name = "field", .colour{0.2, 0.7, 0.2}, .ambient = 0.1, .diffuse = 0.5});
    mesh.flat({{50, 50, 0}, {-50, 50, 0}, {-50, -50, 0}, {50, -50, 0}});
    mesh.material({.name = "wood", .colour{0.55, 0.4, 0.2}, .ambient = 0.1, .diffuse = 0.5});
}

std::uint64_t branches(int size) { return (std::uint64_t{2} << size) - 1; }

}   // namespace

PrimitiveCounts tree_counts(int size, Primitives primitives, int sectors) {
    const std::uint64_t all = branches(size), cones = all * cone_triangles(sectors);
    if (primitives == Primitives::native) return {.triangles = cones + 2, .spheres = all};
    return {.triangles = all * sphere_triangles + cones + 2};
}

Scene make_tree(int size, Primitives primitives, int sectors) {
    Scene scene;
    MeshWriter mesh(scene, primitives, sectors);
    const std::uint64_t vertices =
        (primitives == Primitives::native ? 0 : sphere_vertices) + cone_vertices(sectors);
    mesh.reserve(branches(size) * vertices + 4, tree_counts(size, primitives, sectors), true);
    begin_tree(scene, mesh);
    each_branch(size,
                [&](const glm::dvec3& base, double base_radius, const glm::dvec3& top, double top_radius) {
                    mesh.cone(base, base_radius, top, top_radius);
                    mesh.sphere(top, top_radius);
                });
    return scene;
}

std::uint64_t boughs_triangles(int size) {
    return tree_counts(size, Primitives::triangles, cone_sectors).triangles;
}

PlacedScene make_boughs(int size) {
    PlacedScene scene;
    MeshWriter mesh(scene.own);
    begin_tree(scene.own, mesh);
    Scene cone;   // upright, of height 1
    MeshWriter writer(cone);
    writer.use_material(wood);
    writer.cone(glm::dvec3(0), 1, {0, 0, 1}, taper);
    scene.meshes = {{"cone", cone.vertices, cone.normals, cone.triangles}, ball_mesh(wood)};
    const Circle upright = ring_around({0, 0, 1});
    const glm::dmat3 to_upright =
        glm::transpose(glm::dmat3(upright.start, upright.quarter, glm::dvec3(0, 0, 1)));
    each_branch(
        size, [&](const glm::dvec3& base, double base_radius, const glm::dvec3& top, double top_radius) {
            const Circle ring = ring_around(unit(top - base));
            glm::dmat4 place(glm::dmat3(base_radius * ring.start, base_radius * ring.quarter, top - base) *
                             to_upright);
            place[3] = glm::dvec4(base, 1);
            scene.instances.push_back({"a branch", 0, place, {}});
            scene.instances.push_back(ball_at(top, top_radius, 1));
        });
    return scene;
}

}   // namespace rayclock
