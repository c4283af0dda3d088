#pragma once
// Pictures in files: writing, reading back and comparing.
#include <functional>
#include <string>

#include "model/scene/hit_shading.hpp"
#include "sim/files/output.hpp"

namespace rayclock {

/// Writes a picture: .png is 8-bit sRGB, .exr is linear half float with layers for depth ("Z") and primitive
/// id ("id"). The file appears whole or not at all, see sim/files/output.hpp. Throws UserError if it cannot
/// write or does not know the extension. Throws std::runtime_error once `stop` returns true.
void write_picture(
    const std::string& path, const Picture& picture, const HitFrame& hits,
    const std::function<bool()>& stop = [] { return false; });

/// Returns the bytes of the PNG file that write_picture() writes.
std::string png_bytes(const Picture& picture);

/// Reads a picture as linear RGB. Throws UserError if it is missing or not an image.
Picture read_picture(const std::string& path);

/// The difference of two pictures of one size as 8-bit sRGB. `psnr_db` is the peak signal-to-noise ratio in
/// dB over all channels (infinite if equal). `pixels_beyond` counts pixels in which any channel differs by
/// more than `tolerance`.
struct PictureDifference {
    double psnr_db = 0;
    std::uint64_t pixels_beyond = 0;
    int largest = 0;   ///< largest channel difference, 0..255
};
/// Compares two pictures. Throws UserError if their sizes differ.
PictureDifference compare(const Picture& a, const Picture& b, int tolerance = 0);

/// Throws UserError if write_picture() could not write to `path`. Call it before the work for the picture.
void check_picture_path(const std::string& path);

}   // namespace rayclock
