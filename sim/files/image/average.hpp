#pragma once
#include <string>

#include <glm/vec4.hpp>

namespace rayclock {

/// The mean of all pixels of a PNG or JPEG in memory: linear red, green and blue, and opacity. Throws
/// std::runtime_error with the reason if it is neither, or damaged.
glm::vec4 average_colour(const std::string& bytes);

}   // namespace rayclock
