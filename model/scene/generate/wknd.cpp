// The scene WKND of LumiBench and Vulkan-Sim: the cover of Shirley's "Ray Tracing in One Weekend". Its
// spheres follow the published generator (ubc-aamodt-group/RayTracingInVulkan, src/SceneList.cpp), which
// draws them with std::mt19937(42) in single precision. Shading differs: our materials have neither fuzzy
// reflection nor light from the sky, so two point lights stand in for the sky.
#include "model/scene/generate/generate.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

/// The generator's random numbers in [0, 1), as libstdc++'s std::uniform_real_distribution<float> makes them.
class Dice {
public:
    float roll() {
        constexpr float below_one = 0x1.fffffep-1f;
        return std::min(float(engine_()) * 0x1p-32f, below_one);
    }
    /// Rolls blue, green and red, in this order.
    template <class Channel> glm::dvec3 colour(Channel channel) {
        const float b = channel(), g = channel(), r = channel();
        return {r, g, b};
    }

private:
    std::mt19937 engine_{42};
};

Material matt(const glm::dvec3& colour) {
    return {.name = {}, .colour = colour, .ambient = 0.3, .diffuse = 0.7};
}
Material metal(const glm::dvec3& colour) {
    return {.name = {}, .colour = colour, .ambient = 0.1, .diffuse = 0.1, .mirror = 0.8};
}
Material glass() {
    return {.name = {},
            .colour = glm::dvec3(1),
            .ambient = 0.1,
            .diffuse = 0,
            .mirror = 0.1,
            .transmit = 0.9,
            .index = 1.5};
}

void add(Scene& scene, const glm::dvec3& centre, double radius, const Material& material) {
    scene.spheres.push_back({centre, radius, std::uint32_t(scene.materials.size())});
    scene.materials.push_back(material);
    scene.materials.back().name = "sphere " + std::to_string(scene.spheres.size() - 1);
}

/// Adds the small spheres: one in each cell of a grid, unless the large metal sphere is near.
void add_small(Scene& scene) {
    Dice dice;
    const auto roll = [&] { return dice.roll(); };
    constexpr float small = 0.2f;
    for (int i = -11; i < 11; ++i)
        for (int j = -11; j < 11; ++j) {
            const float kind = roll(), z = float(j) + 0.9f * roll(), x = float(i) + 0.9f * roll();
            const float dx = x - 4;
            if (!(std::sqrt(dx * dx + z * z) > 0.9f)) continue;
            Material material = glass();
            if (kind < 0.8f) {
                material = matt(dice.colour([&] {
                    const float a = roll();
                    return a * roll();
                }));
            } else if (kind < 0.95f) {
                roll();   // the fuzziness of the reflection
                material = metal(dice.colour([&] { return 0.5f * (1 + roll()); }));
            }
            add(scene, {x, small, z}, small, material);
        }
}

}   // namespace

Scene make_wknd(int) {
    Scene scene;
    scene.background = {0.6, 0.75, 1};
    scene.camera = Camera{{13, 2, 3}, {0, 0, 0}, {0, 1, 0}, 20};
    scene.lights = white_lights({{20, 30, 15}, {-15, 25, -20}});
    add(scene, {0, -1000, 0}, 1000, matt(glm::dvec3(0.5)));
    add_small(scene);
    add(scene, {0, 1, 0}, 1, glass());
    add(scene, {-4, 1, 0}, 1, matt({0.4f, 0.2f, 0.1f}));
    add(scene, {4, 1, 0}, 1, metal({0.7f, 0.6f, 0.5f}));
    return scene;
}

}   // namespace rayclock
