#pragma once
#include <functional>
#include <string>

#include "model/scene/hit_shading.hpp"
#include "sim/files/output.hpp"

namespace rayclock {

/// Writes a picture: .png is 8-bit sRGB, .exr is linear half float with depth ("Z") and primitive id ("id")
/// layers. It appears whole or not at all, see sim/files/output.hpp. Throws UserError if it cannot be written
/// or the ending is unknown, and std::runtime_error once `stop` is true.
void write_picture(
    const std::string& path, const Picture& picture, const HitFrame& hits,
    const std::function<bool()>& stop = [] { return false; });

/// The bytes of a PNG file, as write_picture() writes it.
std::string png_bytes(const Picture& picture);

/// Reads a picture back as linear RGB. Throws UserError if it is missing or not an image.
Picture read_picture(const std::string& path);

/// How far two pictures of one size are apart, as 8-bit sRGB values: peak signal-to-noise ratio in dB over
/// all channels (infinite if equal), and the count of pixels where any channel differs by more than
/// `tolerance`.
struct PictureDifference {
    double psnr_db = 0;
    std::uint64_t pixels_beyond = 0;
    int largest = 0;   ///< largest channel difference, 0..255
};
PictureDifference compare(const Picture& a, const Picture& b, int tolerance = 0);

/// Fails early (UserError) if write_picture() could not write to `path`, before the work for it is done.
void check_picture_path(const std::string& path);

}   // namespace rayclock
