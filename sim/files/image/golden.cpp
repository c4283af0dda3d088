// Checking a picture against its golden picture.
#include "sim/files/image/golden.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

namespace rayclock {

std::string golden_path(const std::string& folder, const std::string& scene_spec, FrameSize size) {
    std::string name = scene_spec;
    // The scene may be the path of a file: replace the slashes, so that the name stays inside the folder.
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ':' || c == '/'; }, '_');
    return (std::filesystem::path(folder) / fmt::format("{}_{}x{}.png", name, size.width, size.height))
        .string();
}

GoldenBounds golden_bounds(int coord_bits) {
    const double coarser = std::exp2(std::max(0, golden_coord_bits - coord_bits));
    return {golden_min_psnr_db - 10 * std::log10(coarser), golden_max_beyond * coarser};
}

GoldenResult check_golden(const std::string& folder, const std::string& scene_spec, const Picture& picture,
                          int coord_bits) {
    GoldenResult result;
    const std::string path = golden_path(folder, scene_spec, picture.size);
    std::error_code error;
    result.found = std::filesystem::exists(path, error);
    if (!result.found) return result;
    const PictureDifference difference = compare(read_picture(path), picture, golden_tolerance);
    result.psnr_db = difference.psnr_db;
    result.pixels_beyond = difference.pixels_beyond;
    const double beyond =
        static_cast<double>(difference.pixels_beyond) / static_cast<double>(picture.pixels.size());
    const GoldenBounds bounds = golden_bounds(coord_bits);
    result.within = difference.psnr_db >= bounds.min_psnr_db && beyond <= bounds.max_beyond;
    return result;
}

}   // namespace rayclock
