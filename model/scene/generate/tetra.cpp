// Haines' "tetra": Sierpinski's tetrahedron. Neighbours that touch at a corner do not share its vertex.
#include "model/scene/generate/generate.hpp"

#include <array>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

constexpr std::array<glm::dvec3, 4> tetra_corners{{{-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {1, 1, 1}}};

void pyramid(MeshWriter& mesh, int depth, const glm::dvec3& centre, double half_side) {
    if (depth > 1) {
        for (const glm::dvec3& corner : tetra_corners)
            pyramid(mesh, depth - 1, centre + half_side / 2 * corner, half_side / 2);
        return;
    }
    std::array<std::uint32_t, 4> p{};
    for (std::size_t k = 0; k < 4; ++k) p[k] = mesh.vertex(centre + half_side * tetra_corners[k]);
    mesh.triangle(p[0], p[1], p[2]);
    mesh.triangle(p[3], p[2], p[1]);
    mesh.triangle(p[2], p[3], p[0]);
    mesh.triangle(p[1], p[0], p[3]);
}

}   // namespace

std::uint64_t tetra_triangles(int size) { return std::uint64_t{1} << 2 * size; }

Scene make_tetra(int size) {
    Scene scene;
    scene.camera = Camera{{1.022846, -3.177154, -2.174512},
                          {-0.004103, -0.004103, 0.216539},
                          {-0.816497, -0.816497, 0.816497},
                          45};
    scene.lights = white_lights({{2, -18, -5}});
    MeshWriter mesh(scene);
    mesh.reserve(tetra_triangles(size), {.triangles = tetra_triangles(size)}, false);
    mesh.material({.name = "tetra", .colour{1, 0.2, 0.2}, .ambient = 0.1, .diffuse = 1});
    pyramid(mesh, size, glm::dvec3(0), 1);
    return scene;
}

}   // namespace rayclock
