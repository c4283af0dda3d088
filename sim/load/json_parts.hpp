// The small parts of a JSON scene that need nothing but their own value.
#pragma once
#include <glm/mat4x4.hpp>

#include "model/scene/scene.hpp"
#include "sim/load/json_value.hpp"

namespace rayclock {

Camera camera_of(const JsonValue& in);
Light light_of(const JsonValue& in);
Material material_of(const JsonValue& in, const std::string& name);

/// Inline "vertices" and "triangles", all of material 0.
Scene inline_mesh(const JsonValue& in);

/// translate * rotate * scale, or "matrix". Refuses what flattens or blows up a mesh.
glm::dmat4 transform_of(const JsonValue& object);

} // namespace rayclock
