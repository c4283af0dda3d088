#pragma once
// Small meshes and rays for the tests of the reference tracer. They share nothing with the built-in scenes.
#include <map>
#include <random>
#include <utility>

#include <glm/geometric.hpp>

#include "model/scene/scene.hpp"

namespace rayclock {

using MeshRng = std::mt19937_64;

inline double uniform(MeshRng& rng, double lo, double hi) {
    // Not std::uniform_real_distribution, whose digits differ between libraries.
    return lo + (hi - lo) * static_cast<double>(rng() >> 11) * 0x1p-53;
}

inline glm::dvec3 random_point(MeshRng& rng, double half_side = 1) {
    const double x = uniform(rng, -half_side, half_side), y = uniform(rng, -half_side, half_side);
    return {x, y, uniform(rng, -half_side, half_side)};
}

inline glm::dvec3 random_direction(MeshRng& rng) {
    for (;;) {
        const glm::dvec3 p = random_point(rng);
        const double length = glm::length(p);
        if (length > 0.1 && length < 1) return p / length;
    }
}

inline void add_triangle(Scene& scene, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const auto first = static_cast<std::uint32_t>(scene.vertices.size());
    scene.vertices.insert(scene.vertices.end(), {a, b, c});
    scene.triangles.push_back({{first, first + 1, first + 2}, 0});
}

inline Scene empty_scene() {
    Scene scene;
    scene.materials.emplace_back();
    return scene;
}

/// Returns random triangles of about `size` in -1..1, then scaled and moved.
inline Scene soup(MeshRng& rng, int count, double size, double scale = 1,
                  const glm::dvec3& offset = glm::dvec3(0)) {
    Scene scene = empty_scene();
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 middle = random_point(rng);
        const glm::dvec3 a = middle + random_point(rng, size), b = middle + random_point(rng, size);
        const glm::dvec3 c = middle + random_point(rng, size);
        add_triangle(scene, a * scale + offset, b * scale + offset, c * scale + offset);
    }
    return scene;
}

/// Returns a closed sphere: an octahedron with every triangle divided in four `level` times. Neighbours share
/// vertices.
inline Scene sphere(int level, double radius = 1, const glm::dvec3& centre = glm::dvec3(0)) {
    Scene scene = empty_scene();
    scene.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (std::uint32_t x : {0u, 1u})
        for (std::uint32_t y : {2u, 3u})
            for (std::uint32_t z : {4u, 5u})
                faces.push_back((x + y + z) % 2 == 0 ? std::array{x, y, z} : std::array{x, z, y});
    for (; level > 0; --level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), scene.vertices.size());
            if (is_new) scene.vertices.push_back(glm::normalize(scene.vertices[a] + scene.vertices[b]));
            return place->second;
        };
        std::vector<std::array<std::uint32_t, 3>> finer;
        for (const auto& [a, b, c] : faces) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        faces = std::move(finer);
    }
    for (glm::dvec3& v : scene.vertices) v = centre + radius * v;
    for (const auto& face : faces) scene.triangles.push_back({face, 0});
    return scene;
}

/// Returns the 12 triangles of an axis-parallel box.
inline Scene box(const glm::dvec3& lo, const glm::dvec3& hi) {
    Scene scene = empty_scene();
    for (std::uint32_t i = 0; i < 8; ++i)
        scene.vertices.emplace_back(i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z);
    constexpr std::array<std::array<std::uint32_t, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : sides) {
        scene.triangles.push_back({{a, b, c}, 0});
        scene.triangles.push_back({{a, c, d}, 0});
    }
    return scene;
}

}   // namespace rayclock
