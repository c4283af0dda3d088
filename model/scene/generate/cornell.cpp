// The Cornell box, after the measurements of the real one that Cornell University published (millimetres). It
// is a room open towards the camera, with a red and a green wall and two white blocks on the floor. Adjacent
// sides share corners. The lamp is a panel that fills a hole in the ceiling. As lights have no area here, a
// point light hangs a little below it. Everything is flat: there are no normals.
#include "model/scene/generate/generate.hpp"

#include <array>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

using Corners = std::array<std::uint32_t, 4>;

void quad(MeshWriter& mesh, const Corners& c) {
    mesh.triangle(c[0], c[1], c[2]);
    mesh.triangle(c[2], c[3], c[0]);
}

Corners add(MeshWriter& mesh, const std::array<glm::dvec3, 4>& points) {
    return {mesh.vertex(points[0]), mesh.vertex(points[1]), mesh.vertex(points[2]), mesh.vertex(points[3])};
}

constexpr std::uint64_t room = 2 * 4, ceiling_and_lamp = 2 * 5, block_sides = 2 * 5;

/// Writes four sides and the top over a foot, which is counter-clockwise seen from above and stands on the
/// floor.
void block(MeshWriter& mesh, const std::array<glm::dvec3, 4>& foot, double height) {
    std::array<glm::dvec3, 4> head = foot;
    for (glm::dvec3& p : head) p.y = height;
    const Corners low = add(mesh, foot), high = add(mesh, head);
    quad(mesh, high);
    for (std::size_t i = 0; i < 4; ++i) quad(mesh, {low[i], low[(i + 1) % 4], high[(i + 1) % 4], high[i]});
}

struct Walls {
    bool closed = false;   ///< adds a fifth wall, towards the camera, of the back wall's material
    Material back{.name = "white", .colour = glm::dvec3(0.73), .ambient = 0.15, .diffuse = 0.9};
    Material red{.name = "red", .colour{0.65, 0.05, 0.05}, .ambient = 0.15, .diffuse = 0.9};
    Material green{.name = "green", .colour{0.12, 0.45, 0.15}, .ambient = 0.15, .diffuse = 0.9};
};

Scene make_box(const Walls& walls);

}   // namespace

std::uint64_t cornell_triangles(int) { return room + ceiling_and_lamp + 2 * block_sides; }
std::uint64_t mirrors_triangles(int) { return cornell_triangles(1) + 2; }

Scene make_cornell(int) { return make_box({}); }

/// All four walls are mirrors, and the camera is inside: a ray continues until it meets the floor, the
/// ceiling or a block. The two coloured walls face each other. Each keeps a little of its colour, so one can
/// count the reflections.
Scene make_mirrors(int) {
    Walls walls;
    walls.closed = true;
    for (Material* wall : {&walls.back, &walls.red, &walls.green}) {
        wall->name += " mirror";
        wall->diffuse = 0.25;
        wall->mirror = 0.75;
    }
    Scene scene = make_box(walls);
    scene.camera = Camera{{500, 400, 60}, {60, 390, 290}, {0, 1, 0}, 55};   // above the blocks
    return scene;
}

namespace {

Scene make_box(const Walls& walls) {
    Scene scene;
    scene.background = glm::dvec3(0);
    // A 25 mm film behind a 35 mm lens.
    scene.camera = Camera{{278, 273, -800}, {278, 273, 0}, {0, 1, 0}, 39.3};
    scene.lights = white_lights({{278, 500, 279.5}});
    MeshWriter mesh(scene);
    const Corners floor = add(mesh, {{{552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2}}});
    const Corners ceiling =
        add(mesh, {{{556, 548.8, 0}, {0, 548.8, 0}, {0, 548.8, 559.2}, {556, 548.8, 559.2}}});
    const Corners lamp =
        add(mesh, {{{343, 548.8, 227}, {213, 548.8, 227}, {213, 548.8, 332}, {343, 548.8, 332}}});

    mesh.material({.name = "white", .colour = glm::dvec3(0.73), .ambient = 0.15, .diffuse = 0.9});
    quad(mesh, floor);
    if (!walls.closed) quad(mesh, {floor[3], floor[2], ceiling[2], ceiling[3]});
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        quad(mesh, {ceiling[next], ceiling[i], lamp[i], lamp[next]});
    }
    block(mesh, {{{130, 0, 65}, {82, 0, 225}, {240, 0, 272}, {290, 0, 114}}}, 165);
    block(mesh, {{{423, 0, 247}, {265, 0, 296}, {314, 0, 456}, {472, 0, 406}}}, 330);
    if (walls.closed) {
        mesh.material(walls.back);
        quad(mesh, {floor[3], floor[2], ceiling[2], ceiling[3]});
        quad(mesh, {floor[1], floor[0], ceiling[0], ceiling[1]});
    }
    mesh.material(walls.red);
    quad(mesh, {floor[0], floor[3], ceiling[3], ceiling[0]});
    mesh.material(walls.green);
    quad(mesh, {floor[2], floor[1], ceiling[1], ceiling[2]});
    mesh.material({.name = "lamp", .colour = glm::dvec3(1), .ambient = 1, .diffuse = 0});
    quad(mesh, {lamp[3], lamp[2], lamp[1], lamp[0]});
    return scene;
}

}   // namespace

}   // namespace rayclock
