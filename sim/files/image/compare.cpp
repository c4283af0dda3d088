// Comparing two pictures as 8-bit sRGB.
#include "sim/files/image/image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/image/srgb.hpp"

namespace rayclock {
namespace {

void check_same_size(FrameSize a, FrameSize b) {
    if (a != b)
        throw UserError(fmt::format("pictures of {}x{} and {}x{} pixels cannot be compared", a.width,
                                    a.height, b.width, b.height));
}

/// Returns the largest difference over the three channels, in steps of 8-bit sRGB.
int largest_difference(const std::array<std::uint8_t, 3>& a, const std::array<std::uint8_t, 3>& b) {
    int largest = 0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
    return largest;
}

}   // namespace

PictureDifference compare(const Picture& a, const Picture& b, int tolerance) {
    check_same_size(a.size, b.size);
    PictureDifference difference;
    std::uint64_t squares = 0;   // exact: at most 3 * 2^28 * 255^2 < 2^46
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const auto x = srgb_bytes(a.pixels[i]), y = srgb_bytes(b.pixels[i]);
        for (int c = 0; c < 3; ++c) squares += static_cast<std::uint64_t>((x[c] - y[c]) * (x[c] - y[c]));
        const int largest = largest_difference(x, y);
        difference.largest = std::max(difference.largest, largest);
        if (largest > tolerance) ++difference.pixels_beyond;
    }
    const double mean = static_cast<double>(squares) / (3.0 * static_cast<double>(a.pixels.size()));
    difference.psnr_db =
        squares == 0 ? std::numeric_limits<double>::infinity() : 10 * std::log10(255.0 * 255.0 / mean);
    return difference;
}

}   // namespace rayclock
