#pragma once
// Textures of a glTF document: as pictures with their samplers and transforms, or reduced to their average
// colours.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/load/gltf/buffers.hpp"
#include "sim/load/gltf/material.hpp"

namespace rayclock {

/// The coordinates of a texture: the set TEXCOORD_n, and KHR_texture_transform.
struct GltfMapping {
    std::uint64_t set = 0;
    glm::dvec2 offset{0}, scale{1};
    double rotation = 0;   ///< radians, anticlockwise where t counts down
    glm::dvec2 operator()(const glm::dvec2& st) const;
};

/// Reads the textures, each picture once.
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

    /// Returns the index of a material's texture in all(). Returns nothing if the load averages textures or
    /// the picture cannot be read; the caller then uses tint(). Throws UserError if the document is wrong.
    std::optional<std::uint32_t> texture(const GltfMaterial& material);
    /// Applies the average opacity of a texture, as tint() does.
    void take_opacity(GltfMaterial& material, std::uint32_t texture) const;
    /// Returns how a material's base texture maps to the mesh.
    GltfMapping mapping(const GltfMaterial& material) const;
    const std::vector<Texture>& all() const { return all_; }

private:
    /// A picture with the mean of its alpha.
    struct GltfPicture {
        std::shared_ptr<const Pyramid> pyramid;   ///< null: cannot be read
        float opacity = 1;
    };
    GltfPicture picture(std::uint64_t image);
    void sample(const JsonValue& texture, Texture& out) const;
    void count_opacity(GltfMaterial& material) const;
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
    std::map<std::uint64_t, GltfPicture> pictures_;                // by image
    std::map<std::uint64_t, std::uint32_t> numbers_;               // by texture
    std::vector<Texture> all_;
    std::vector<float> opacities_;   // of all_
};

}   // namespace rayclock
