// The scene of Vortex's test rt_raycast: a cube of 12 triangles, with the camera that this test computes.
#include "model/scene/generate/generate.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {

std::uint64_t cube_triangles(int) { return 12; }

Scene make_cube(int) {
    Scene scene;
    MeshWriter mesh(scene);
    mesh.reserve(24, {.triangles = cube_triangles(1)}, false);
    mesh.material({.name = "cube", .colour = glm::dvec3(1), .ambient = 0.12, .diffuse = 0.85});
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 out(0), u(0), v(0);
            out[axis] = side, u[(axis + 1) % 3] = side, v[(axis + 2) % 3] = 1;
            mesh.flat({out - u - v, out + u - v, out + u + v, out - u + v});
        }
    // The camera is 2.6 radii away, where the radius is half the diagonal of the bounds.
    const double radius = std::sqrt(3.0);
    scene.camera = Camera{2.6 * radius * glm::normalize(glm::dvec3(0.4, 0.35, 1)), {0, 0, 0}, {0, 1, 0}, 50};
    scene.lights = white_lights({radius * glm::dvec3(3, 4, 2)});
    scene.background = {0.05, 0.06, 0.08};
    return scene;
}

}   // namespace rayclock
