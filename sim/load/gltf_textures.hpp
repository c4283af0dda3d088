// Textures of a glTF document, each as one colour: its mean.
#pragma once
#include <map>
#include <optional>
#include <string>

#include "sim/load/gltf_buffers.hpp"
#include "sim/load/gltf_material.hpp"

namespace rayclock {

constexpr const char* averaged_texture = "with a texture of its colour, drawn in the mean of the texture";

class GltfTextures {
public:
    /// The document and the buffers must outlive it.
    GltfTextures(const JsonValue& document, GltfBuffers& buffers, Loading& loading, Warnings& warnings,
                 std::string file)
        : in_(document), buffers_(buffers), loading_(loading), warnings_(warnings), file_(std::move(file)) {}

    /// The base colour of a material with a texture is multiplied by the texture's mean. A mesh often travels
    /// without its pictures: one that cannot be read is told, and leaves the colour as it is. Returns true if
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
    std::map<std::uint64_t, std::optional<glm::vec4>> averages_;   // of images
};

}   // namespace rayclock
