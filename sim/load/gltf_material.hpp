// Materials, cameras and lights of a glTF document.
#pragma once
#include <glm/mat4x4.hpp>

#include "model/scene/scene.hpp"
#include "sim/files/json_value.hpp"
#include "sim/load/surface.hpp"

namespace rayclock {

struct GltfMaterial {
    std::string name;
    GltfSurface surface;
    bool blends = false;                     ///< its opacity counts
    bool is_masked = false;                  ///< its opacity decides what is seen at all
    bool is_invisible = false;               ///< nothing of it is
    bool has_textures = false;               ///< others than that of the base colour
    bool has_extensions = false;             ///< such as are not drawn
    std::optional<JsonValue> base_texture;   ///< how the file names that of the base colour
};
GltfMaterial gltf_material(const JsonValue& in, std::size_t number);

/// The matrix of a node, with the 32-bit floats that the format is made for.
glm::dmat4 gltf_transform(const JsonValue& node);

/// Nothing for parallel rays, which are not in our camera.
std::optional<Camera> gltf_camera(const JsonValue& in, const glm::dmat4& place);

PlacedLight gltf_light(const JsonValue& in, const glm::dmat4& place);

}   // namespace rayclock
