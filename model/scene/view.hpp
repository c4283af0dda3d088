#pragma once
#include <string>

#include <glm/vec3.hpp>

#include "model/scene/scene.hpp"

namespace rayclock {

// What check_scene(), pixel_rays() and fit_camera() share; nobody else needs it.

/// The camera's axes (spd.md 2.1: w, r, v), unit and at right angles, and tan of half its angle.
struct View {
    glm::dvec3 forward{0}, right{0}, up{0};
    double half_height = 0;
};

/// Throws UserError if the camera looks nowhere or its angle is not in (0, 180). `where` begins the sentence.
View view_of(const Camera& camera, const std::string& where);

/// v must be finite and not zero; its length may be anything a double can hold.
glm::dvec3 unit_of(const glm::dvec3& v);

/// Sees NaN and infinities in any component.
bool is_finite(const glm::dvec3& v);

/// "(1, 0.5, nan)" and "0.5", with as many digits as tell the value from all others.
std::string text_of(const glm::dvec3& v);
std::string text_of(double x);

}   // namespace rayclock
