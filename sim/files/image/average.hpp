#pragma once
// Pictures of textures, and their average colours.
#include <string>

#include <glm/vec4.hpp>

#include "model/scene/texture.hpp"

namespace rayclock {

/// Returns the mean of all pixels of a PNG or JPEG in memory: linear red, green, blue, and opacity. Throws
/// std::runtime_error with the reason if the bytes are neither, or damaged.
glm::vec4 average_colour(const std::string& bytes);

/// The largest side and the largest number of pixels of a picture that decoded_picture() reads.
constexpr int most_picture_side = 16384;
constexpr std::int64_t most_picture_pixels = std::int64_t{1} << 28;

/// Decodes a picture file in memory to sRGB codes with 8 bits and alpha. Reads PNG, JPEG, BMP, TIFF, TGA,
/// OpenEXR and Radiance HDR. Integer channels hold sRGB and floating-point channels linear light, clamped to
/// 0..1. Throws std::runtime_error with the reason if the format is unknown, or the picture is damaged or too
/// large.
TexelLevel decoded_picture(const std::string& bytes);

}   // namespace rayclock
