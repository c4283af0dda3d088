#pragma once
// Scenes read from files with a picture of four texels.
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "sim/files/image/image.hpp"
#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test {

using Notes = std::vector<std::string>;

struct LoadedScene {
    Scene scene;
    Notes notes;

    const Material& material(std::size_t triangle = 0) const {
        return scene.materials[scene.triangles[triangle].material];
    }
    const Texture& texture(std::size_t triangle = 0) const {
        return scene.textures.at(material(triangle).texture.value());
    }
};

inline LoadedScene read_scene(const std::string& spec, Textures textures = Textures::drawn) {
    LoadedScene made;
    made.scene = load_scene(spec, {}, Primitives::triangles, &made.notes, textures);
    return made;
}

/// A picture of 2 x 2 pixels: white, red, green, blue.
inline std::string four_texels() { return png_bytes({{2, 2}, {{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}); }

/// Returns the sentence that refuses a file next to p.png, or an empty string if it loads.
inline std::string refusal_of(const std::string& name, const std::string& bytes) {
    const SceneFolder folder;
    folder.write("p.png", four_texels());
    const std::string said = complaint(folder.write(name, bytes));
    CHECK(said.find('\n') == said.npos);
    return said;
}

/// Requires that each corner has the coordinates (x, y) * scale + offset of its place, with t inverted: it
/// increases upwards in the file and downwards in the scene.
inline void check_coordinates(const Scene& scene, const glm::dvec2& scale = glm::dvec2(1),
                              const glm::dvec2& offset = glm::dvec2(0)) {
    REQUIRE(scene.coordinates.size() == scene.triangles.size());
    const std::vector<Corners> corners = corners_of(scene);
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            CAPTURE(i, k);
            const glm::dvec2 given = glm::dvec2(corners[i][k]) * scale + offset;
            CHECK(glm::length(scene.coordinates[i][k] - glm::dvec2(given.x, 1 - given.y)) < 1e-6);
        }
}

}   // namespace rayclock::test
