// The small parts of a JSON scene that need nothing but their own value.
#pragma once
#include <glm/mat4x4.hpp>

#include "model/scene/scene.hpp"
#include "sim/files/json_value.hpp"

namespace rayclock {

Camera camera_of(const JsonValue& in);
Light light_of(const JsonValue& in);
Material material_of(const JsonValue& in, const std::string& name);

/// Without their materials, which the file's names decide.
Sphere sphere_of(const JsonValue& in);
Plane plane_of(const JsonValue& in);

/// Three numbers within 0 and 1.
glm::dvec3 colour_of(const JsonValue& in);
/// True, false, or `otherwise` if the key is missing.
bool flag_or(const JsonValue& in, std::string_view key, bool otherwise);

/// Inline "vertices" and "triangles", all of material 0.
Scene inline_mesh(const JsonValue& in);

/// translate * rotate * scale, or "matrix". Refuses what flattens or blows up a mesh.
glm::dmat4 transform_of(const JsonValue& object);

/// A map that makes solids flat, or has lengths that are beyond any use.
bool is_singular(const glm::dmat4& m);

/// True if it keeps all angles, so that a sphere stays one.
bool keeps_spheres(const glm::dmat4& place);

}   // namespace rayclock
