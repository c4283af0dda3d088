#pragma once
// Pictures of textures, and their average colours.
#include <string>

#include <glm/vec4.hpp>

#include "model/scene/texture.hpp"

namespace rayclock {

/// The largest side and the largest number of pixels of a picture that these functions read.
constexpr int max_picture_side = 16384;
constexpr std::int64_t max_picture_pixels = std::int64_t{1} << 28;
/// A decoded picture may take least_picture_bytes, or picture_bytes_for_a_byte for each byte of its file if
/// that is more. Without this limit a compressed file of 33 kB could fill memory with 2^28 equal texels.
constexpr std::int64_t least_picture_bytes = std::int64_t{1} << 28, picture_bytes_for_a_byte = 256;

/// Decodes a picture file in memory to sRGB codes with 8 bits and alpha. Reads PNG, JPEG, BMP, TIFF, TGA
/// (with the footer of version 2), OpenEXR and Radiance HDR. Integer channels hold sRGB and floating-point
/// channels linear light, clamped to 0..1. Throws std::runtime_error with the reason if the format is
/// unknown, or the picture is damaged or too large.
TexelLevel decoded_picture(const std::string& bytes);

/// Returns the mean of all pixels of such a file: linear red, green, blue, and opacity. Throws the same
/// errors.
glm::vec4 average_colour(const std::string& bytes);

}   // namespace rayclock
