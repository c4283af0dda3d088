// Haines' "teapot": Newell's teapot on a checkerboard.
//
// Patches that share a row of control points, in either direction, get bitwise equal vertices along it. The
// weights and the sums below are symmetric under reversal of a parameter, and exact at its ends.
#include "model/scene/generate/generate.hpp"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/scene/generate/mesh_writer.hpp"
#include "model/scene/generate/teapot_patches.hpp"

namespace rayclock {
namespace {

using BezierWeights = std::array<double, 4>;

/// Returns Bernstein's cubic polynomials at u = i / n.
BezierWeights bernstein(int i, int n) {
    const double u = static_cast<double>(i) / n, w = static_cast<double>(n - i) / n;
    return {w * (w * w), 3 * (u * (w * w)), 3 * (w * (u * u)), u * (u * u)};
}

/// Returns their derivatives.
BezierWeights bernstein_slope(int i, int n) {
    const double u = static_cast<double>(i) / n, w = static_cast<double>(n - i) / n;
    return {-3 * w * w, 3 * w * w - 6 * u * w, 6 * u * w - 3 * u * u, 3 * u * u};
}

template <class T> T weighted(const BezierWeights& b, const std::array<T, 4>& q) {
    return (b[0] * q[0] + b[3] * q[3]) + (b[1] * q[1] + b[2] * q[2]);
}

glm::dvec3 evaluate(const TeapotPatch& patch, const BezierWeights& s, const BezierWeights& t) {
    std::array<glm::dvec3, 4> row;
    for (std::size_t r = 0; r < 4; ++r)
        row[r] =
            weighted<glm::dvec3>(t, {patch[4 * r], patch[4 * r + 1], patch[4 * r + 2], patch[4 * r + 3]});
    return weighted(s, row);
}

/// True at the centres of the lid's knob and of the bottom, where a whole row of a patch is one point.
bool is_cusp(const glm::dvec3& p) { return std::abs(p.x) <= 1e-4 && std::abs(p.y) <= 1e-4; }

glm::dvec3 normal_at(const TeapotPatch& patch, const glm::dvec3& p, int i, int j, int n) {
    if (is_cusp(p)) return {0, 0, p.z > 1.5 ? 1 : -1};
    const glm::dvec3 p_s = evaluate(patch, bernstein_slope(i, n), bernstein(j, n));
    const glm::dvec3 p_t = evaluate(patch, bernstein(i, n), bernstein_slope(j, n));
    return unit(glm::cross(p_t, p_s));
}

void add_patch(MeshWriter& mesh, const Scene& scene, const TeapotPatch& patch, int n) {
    const auto first = static_cast<std::uint32_t>(scene.vertices.size()),
               row = static_cast<std::uint32_t>(n) + 1;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
            glm::dvec3 p = evaluate(patch, bernstein(i, n), bernstein(j, n));
            if (is_cusp(p)) p = patch[0];   // rounding would pull the copies of the point apart
            mesh.vertex(p, normal_at(patch, p, i, j, n));
        }
    const auto emit = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (is_cusp(scene.vertices[a]) + is_cusp(scene.vertices[b]) + is_cusp(scene.vertices[c]) < 2)
            mesh.triangle(a, b, c);
    };
    for (std::uint32_t i = 0; i + 1 < row; ++i)
        for (std::uint32_t j = 0; j + 1 < row; ++j) {
            const std::uint32_t c = first + i * row + j;
            emit(c, c + 1, c + row + 1);
            emit(c + row + 1, c + row, c);
        }
}

/// All corners lie in one plane, so squares share them. The odd squares come first, then the even ones.
void checkerboard(MeshWriter& mesh, const Scene& scene, int n) {
    const auto first = static_cast<std::uint32_t>(scene.vertices.size()),
               row = static_cast<std::uint32_t>(n) + 1;
    const auto line = [n](int i) { return 4 * (2.0 * i / n - 1); };
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) mesh.vertex({line(i), line(j), 0}, {0, 0, 1});
    for (const std::uint32_t parity : {1u, 0u}) {
        mesh.material({.name = parity == 1 ? "odd squares" : "even squares",
                       .colour = glm::dvec3(parity == 1 ? 1 : 0.5),
                       .ambient = 0.15,
                       .diffuse = 0.5,
                       .highlight = 0.5,
                       .shine = shine_of(30),
                       .mirror = 0.5});
        for (std::uint32_t i = 0; i + 1 < row; ++i)
            for (std::uint32_t j = 0; j + 1 < row; ++j) {
                if ((i + j) % 2 != parity) continue;
                const std::uint32_t c = first + i * row + j;
                mesh.triangle(c, c + row, c + row + 1);
                mesh.triangle(c + row + 1, c + 1, c);
            }
    }
}

}   // namespace

std::uint64_t teapot_triangles(int size) {
    const auto n = static_cast<std::uint64_t>(size);
    return 66 * n * n - 8 * n;
}

Scene make_teapot(int size) {
    Scene scene;
    scene.camera = Camera{{4.86, 7.2, 5.4}, {0, 0, 0}, {0, 0, 1}, 45};
    scene.lights = white_lights({{-3.1, 9.8, 12.1}, {11.3, 5.1, 8.8}});
    MeshWriter mesh(scene);
    const auto grid = static_cast<std::uint64_t>(size + 1) * static_cast<std::uint64_t>(size + 1);
    const std::vector<TeapotPatch> patches = teapot_patches();
    mesh.reserve((patches.size() + 1) * grid, {.triangles = teapot_triangles(size)}, true);
    checkerboard(mesh, scene, size);
    mesh.material({.name = "teapot",
                   .colour{1, 0.5, 0.1},
                   .ambient = 0.15,
                   .diffuse = 0.75,
                   .highlight = 0.25,
                   .shine = shine_of(37),
                   .mirror = 0.25});
    for (const TeapotPatch& patch : patches) add_patch(mesh, scene, patch, size);
    return scene;
}

}   // namespace rayclock
