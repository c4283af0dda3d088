#pragma once
// Textures of a glTF document, each reduced to its average colour.
#include <map>
#include <optional>
#include <string>

#include "sim/load/gltf/buffers.hpp"
#include "sim/load/gltf/material.hpp"

namespace rayclock {

constexpr const char* averaged_texture = "with a texture of its colour, drawn in the mean of the texture";

/// Averages the textures, each once.
class GltfTextures {
public:
    /// The caller must keep the document and the buffers alive.
    GltfTextures(const JsonValue& document, GltfBuffers& buffers, Loading& loading, Warnings& warnings,
                 std::string file)
        : in_(document), buffers_(buffers), loading_(loading), warnings_(warnings), file_(std::move(file)) {}

    /// Multiplies a material's base colour by the average of its texture. Meshes often travel without their
    /// pictures: a picture that cannot be read causes a note and leaves the colour unchanged. Returns true if
    /// it could be read.
    bool tint(GltfMaterial& material);

private:
    std::optional<glm::vec4> average(std::uint64_t image);
    JsonValue list(std::string_view key) const {
        return in_.find(key).value_or(JsonValue(empty_, file_)).array();
    }

    JsonValue in_;
    GltfBuffers& buffers_;
    Loading& loading_;
    Warnings& warnings_;
    std::string file_;
    const Json empty_ = Json::array();
    std::map<std::uint64_t, std::optional<glm::vec4>> averages_;   // by image
};

}   // namespace rayclock
