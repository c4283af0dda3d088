// The sphere picture of the literature (Whitted 1980, and later chips): reflecting spheres and a glass sphere
// above an infinite checkered plane. It has only spheres and a plane; nothing is cut into triangles. Also the
// scenes `plane` and `square`.
#include "model/scene/generate/generate.hpp"
#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

/// Returns the plane y = 0 with squares of side 1 around the origin.
Plane floor_plane(std::uint32_t material) {
    return {.point{0, 0, 0}, .u{1, 0, 0}, .v{0, 0, -1}, .material = material};
}

}   // namespace

Scene make_spheres(int) {
    Scene scene;
    scene.background = {0.25, 0.45, 0.8};
    scene.camera = Camera{{0.6, 1.9, 6.2}, {0, 0.85, 0}, {0, 1, 0}, 40};
    scene.lights = white_lights({{6, 9, 7}, {-8, 6, 4}});
    scene.materials = {
        {.name = "floor",
         .colour{0.9, 0.75, 0.2},
         .ambient = 0.15,
         .diffuse = 0.7,
         .mirror = 0.1,
         .checkered = true,
         .other{0.7, 0.1, 0.08}},
        {.name = "glass",
         .colour = glm::dvec3(1),
         .ambient = 0.1,
         .diffuse = 0.02,
         .highlight = 0.6,
         .shine = 120,
         .mirror = 0.1,
         .transmit = 0.85,
         .index = 1.5},
        {.name = "mirror",
         .colour{0.9, 0.95, 1},
         .ambient = 0.1,
         .diffuse = 0.1,
         .highlight = 0.6,
         .shine = 80,
         .mirror = 0.8},
        {.name = "gold",
         .colour{1, 0.7, 0.25},
         .ambient = 0.15,
         .diffuse = 0.4,
         .highlight = 0.5,
         .shine = 40,
         .mirror = 0.4},
        {.name = "blue",
         .colour{0.15, 0.25, 0.85},
         .ambient = 0.15,
         .diffuse = 0.7,
         .highlight = 0.4,
         .shine = 20,
         .mirror = 0.15},
        {.name = "chalk", .colour{0.9, 0.9, 0.85}, .ambient = 0.15, .diffuse = 0.9},
    };
    scene.spheres = {{{0.75, 1, 1.4}, 0.75, 1},
                     {{-0.9, 1.2, -0.6}, 1.2, 2},
                     {{1.9, 0.7, -1.3}, 0.7, 3},
                     {{-1.35, 0.45, 1.7}, 0.45, 4},
                     {{2.1, 0.3, 0.5}, 0.3, 5}};
    scene.planes = {floor_plane(0)};
    return scene;
}

/// A uniform plane with squares that become smaller than a pixel towards the horizon.
Scene make_plane(int) {
    Scene scene;
    scene.background = {0.45, 0.6, 0.85};
    scene.camera = Camera{{0.3, 1.5, 4}, {0.9, 1.1, 0}, {0, 1, 0}, 45};
    scene.lights = white_lights({{-100, 300, 100}});
    scene.materials = {{.name = "plane",
                        .colour = glm::dvec3(0.95),
                        .ambient = 0.35,
                        .diffuse = 0.65,
                        .checkered = true,
                        .other = glm::dvec3(0.03)}};
    scene.planes = {floor_plane(0)};
    return scene;
}

std::uint64_t square_triangles(int) { return 2; }

/// A square whose edges cross the rows and columns of pixels at about 1 in 11.
Scene make_square(int) {
    Scene scene;
    scene.background = glm::dvec3(0);
    scene.camera = Camera{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 45};
    MeshWriter mesh(scene);
    mesh.reserve(4, {.triangles = square_triangles(1)}, false);
    mesh.material({.name = "white", .colour = glm::dvec3(1), .ambient = 1, .diffuse = 0});
    const double c = 0.996, s = 0.0893;   // about 5 degrees
    mesh.flat({{-c + s, -s - c, 0}, {c + s, s - c, 0}, {c - s, s + c, 0}, {-c - s, -s + c, 0}});
    return scene;
}

}   // namespace rayclock
