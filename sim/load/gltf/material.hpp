#pragma once
// Materials, cameras and lights of a glTF document.
#include <glm/mat4x4.hpp>

#include "model/scene/scene.hpp"
#include "sim/files/json_value.hpp"
#include "sim/load/surface.hpp"

namespace rayclock {

/// A material of the document, before its base texture is averaged.
struct GltfMaterial {
    std::string name;
    GltfSurface surface;
    bool blends = false;                     ///< alphaMode BLEND: the opacity counts
    bool is_masked = false;                  ///< alphaMode MASK: the opacity decides which points exist
    double cutoff = 0;                       ///< of a MASK: opacity below it is a hole
    bool is_invisible = false;               ///< MASK with a constant opacity below the cutoff
    bool has_textures = false;               ///< textures other than that of the base colour
    bool has_extensions = false;             ///< extensions that are not drawn
    std::optional<JsonValue> base_texture;   ///< reference to the texture of the base colour
};
/// Reads a material; `number` names it if it has no name. Throws UserError if the document is wrong.
GltfMaterial gltf_material(const JsonValue& in, std::size_t number);

/// Returns the matrix of a node, computed with 32-bit floats as the format specifies.
glm::dmat4 gltf_transform(const JsonValue& node);

/// Returns a camera at a place, or nothing for an orthographic one, which rayclock does not have.
std::optional<Camera> gltf_camera(const JsonValue& in, const glm::dmat4& place);

/// Returns a light at a place. Throws UserError if the document is wrong.
PlacedLight gltf_light(const JsonValue& in, const glm::dmat4& place);

}   // namespace rayclock
