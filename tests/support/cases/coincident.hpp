#pragma once
// Scenes with coincident primitives.
#include <algorithm>
#include <random>

#include "model/scene/scene.hpp"

namespace rayclock::test {

/// Adds two copies of every triangle with vertices of their own: one with rotated corners, one with reversed
/// order. The triangles are shuffled.
inline Scene tripled(Scene scene, std::uint32_t seed, std::vector<std::uint32_t>& original) {
    const std::size_t count = scene.triangles.size();
    std::vector<Triangle> all;
    original.clear();
    for (std::size_t i = 0; i < 3 * count; ++i) original.push_back(std::uint32_t(i % count));
    std::shuffle(original.begin(), original.end(), std::mt19937{seed});
    std::vector<int> seen(count);
    for (const std::uint32_t i : original) {
        Triangle t = scene.triangles[i];
        const int turn = seen[i]++;
        if (turn == 1) t.vertex = {t.vertex[1], t.vertex[2], t.vertex[0]};
        if (turn == 2) t.vertex = {t.vertex[2], t.vertex[1], t.vertex[0]};
        if (turn > 0)
            for (std::uint32_t& v : t.vertex) {
                scene.vertices.push_back(scene.vertices[v]);
                if (!scene.normals.empty()) scene.normals.push_back(scene.normals[v]);
                v = std::uint32_t(scene.vertices.size() - 1);
            }
        all.push_back(t);
    }
    scene.triangles = all;
    return scene;
}

/// Returns the lowest number of a primitive that coincides with `number`.
inline std::uint32_t lowest(const std::vector<std::uint32_t>& original, std::uint32_t number) {
    return std::uint32_t(std::find(original.begin(), original.end(), original[number]) - original.begin());
}

}   // namespace rayclock::test
