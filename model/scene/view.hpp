#pragma once
// The camera's axes, and checks of vectors in scenes.
#include <string>

#include <glm/vec3.hpp>

#include "model/scene/scene.hpp"

namespace rayclock {

// A camera's axes, and helpers for finite vectors and their text, shared by checks, cameras, motion and
// make_frame().

/// The camera's axes (w, r, v), orthonormal, and the tangent of half its angle.
struct View {
    glm::dvec3 forward{0}, right{0}, up{0};
    double half_height = 0;
};

/// Returns the view of a camera. Throws UserError if it has no view or its angle is not in (0, 180). `where`
/// begins the sentence.
View view_of(const Camera& camera, const std::string& where);

/// Returns the unit vector along v, which must be finite and not zero. Its length may be anything that a
/// double can hold.
glm::dvec3 unit_of(const glm::dvec3& v);

/// True if no component is NaN or infinite.
bool is_finite(const glm::dvec3& v);

/// Return "(1, 0.5, nan)" and "0.5", with the fewest digits that identify the value.
std::string text_of(const glm::dvec3& v);
std::string text_of(double x);

}   // namespace rayclock
