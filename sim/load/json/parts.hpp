#pragma once
// The small parts of a JSON scene. Each needs only its own value. All readers throw UserError if the
// value is wrong.
#include <glm/mat4x4.hpp>

#include "model/scene/motion.hpp"
#include "model/scene/pattern.hpp"
#include "model/scene/scene.hpp"
#include "sim/files/json_value.hpp"

namespace rayclock {

Camera camera_of(const JsonValue& in);
Light light_of(const JsonValue& in);
/// Read the same, and allow other keys next to theirs.
Camera camera_of_keys(const JsonValue& in);
Light light_of_keys(const JsonValue& in);
/// Returns `material` with the keys of `in` replaced.
Material material_of(const JsonValue& in, Material material);
/// Does the same, and allows the key "texture", which the caller reads.
Material material_of_keys(const JsonValue& in, Material material);

/// The value of a material's key "texture".
struct JsonTexture {
    std::string file;                 ///< relative to the scene file; empty with a pattern
    std::optional<Pattern> pattern;   ///< instead of a file
    Texture texture;                  ///< without its picture
};
JsonTexture texture_of(const JsonValue& in);

/// Read a sphere or a plane without its material, which the caller looks up by name.
Sphere sphere_of(const JsonValue& in);
Plane plane_of(const JsonValue& in);

/// Returns three numbers within 0 and 1.
glm::dvec3 colour_of(const JsonValue& in);
/// Returns true or false, or `otherwise` if the key is missing.
bool flag_or(const JsonValue& in, std::string_view key, bool otherwise);

/// Reads inline "vertices", "triangles" and "coordinates", all of material 0.
Scene inline_mesh(const JsonValue& in);

/// A rotation about a unit vector.
struct Turn {
    glm::dvec3 axis{0, 0, 1};
    double degrees = 0;
};
Turn turn_of(const JsonValue& in);
glm::dquat quaternion(const Turn& turn);
/// Returns one scale per axis, from one number or three. Throws UserError if it flattens a mesh or scales it
/// beyond 1e-100 to 1e100.
glm::dvec3 scale_of(const JsonValue& in);
/// Returns a matrix from 16 numbers, row by row. Throws UserError for the same reasons.
glm::dmat4 matrix_of(const JsonValue& in);

/// Returns translate * rotate * scale, or "matrix". Throws UserError for the same reasons.
glm::dmat4 transform_of(const JsonValue& object);

/// Returns true if the matrix keeps all angles, so that a sphere stays a sphere.
bool keeps_spheres(const glm::dmat4& place);

}   // namespace rayclock
