#pragma once
// The average colour of a texture.
#include <string>

#include <glm/vec4.hpp>

namespace rayclock {

/// Returns the mean of all pixels of a PNG or JPEG in memory: linear red, green, blue, and opacity. Throws
/// std::runtime_error with the reason if the bytes are neither, or damaged.
glm::vec4 average_colour(const std::string& bytes);

}   // namespace rayclock
