// The small parts of a JSON scene that need nothing but their own value.
#pragma once
#include <glm/mat4x4.hpp>

#include "model/scene/motion.hpp"
#include "model/scene/scene.hpp"
#include "sim/files/json_value.hpp"

namespace rayclock {

Camera camera_of(const JsonValue& in);
Light light_of(const JsonValue& in);
/// The same whatever other keys there are.
Camera camera_of_keys(const JsonValue& in);
Light light_of_keys(const JsonValue& in);
/// The material with the keys that are given.
Material material_of(const JsonValue& in, Material material);

/// Without their materials, which the file's names decide.
Sphere sphere_of(const JsonValue& in);
Plane plane_of(const JsonValue& in);

/// Three numbers within 0 and 1.
glm::dvec3 colour_of(const JsonValue& in);
/// True, false, or `otherwise` if the key is missing.
bool flag_or(const JsonValue& in, std::string_view key, bool otherwise);

/// Inline "vertices" and "triangles", all of material 0.
Scene inline_mesh(const JsonValue& in);

/// A rotation as it is written: about a unit vector.
struct Turn {
    glm::dvec3 axis{0, 0, 1};
    double degrees = 0;
};
Turn turn_of(const JsonValue& in);
glm::dquat quaternion(const Turn& turn);
/// A number, or one for each axis. Refuses what flattens or blows up a mesh.
glm::dvec3 scale_of(const JsonValue& in);
/// 16 numbers, row by row, likewise.
glm::dmat4 matrix_of(const JsonValue& in);

/// translate * rotate * scale, or "matrix". Refuses what flattens or blows up a mesh.
glm::dmat4 transform_of(const JsonValue& object);

/// True if it keeps all angles, so that a sphere stays one.
bool keeps_spheres(const glm::dmat4& place);

}   // namespace rayclock
