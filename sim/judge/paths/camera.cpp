// Computes directions of camera rays in integers of 128 bits.
#include "sim/judge/paths/camera.hpp"

#include <algorithm>

#include "model/base/axes.hpp"
#include "sim/judge/paths/arithmetic.hpp"

namespace rayclock {

Vec3i exact_direction(const Frame& frame, const Config& config, const Whitted& settings, int x, int y,
                      int sample) {
    constexpr int parts = 256;   // positions across a pixel
    SampleOffset offset;
    if (config.supersampling)
        offset = sample_offset(std::uint32_t(x), std::uint32_t(y), std::uint32_t(sample), settings.aa,
                               settings.jitter, settings.seed);
    const Int128 right = Int128(x) * parts + offset.x, down = Int128(y) * parts + offset.y;
    const Int128 unit = Int128(parts) << guard_bits, end = unit << (config.dir_bits - 1);
    auto sum = by_axis([&](std::size_t k) {
        return Int128(frame.corner[k]) * parts + right * frame.right[k] + down * frame.down[k];
    });
    // Doubled while it fits.
    const auto fits_twice = [&](Int128 v) { return -end <= 2 * v && 2 * v < end; };
    for (int doubled = 0; doubled < max_shift && std::all_of(sum.begin(), sum.end(), fits_twice); ++doubled)
        for (Int128& v : sum) v *= 2;
    const Int128 most = end / unit - 1, least = config.has_instances() ? -most : -most - 1;
    return by_axis([&](std::size_t k) {
        return std::int32_t(std::clamp<Int128>(nearest_of(sum[k], unit), least, most));
    });
}

bool same_hit(const Closest& a, const Closest& b) {
    return a.found == b.found && a.prim == b.prim && a.t == b.t && a.u == b.u && a.v == b.v;
}

}   // namespace rayclock
