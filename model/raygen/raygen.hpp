#pragma once
#include "model/core/payloads.hpp"

namespace rayclock {

/// Camera ray through the centre of pixel (x, y), and the reciprocals of its direction rounded down.
///
/// d = round((corner + x right + y down) / 2^guard_bits), halves up; M bits, the host sees to it that it fits.
/// Mirror of rtl/raygen/rc_raygen.sv, latency Config::raygen_latency() + 1, one ray per cycle.
Ray raygen(const Slot& slot, const Frame& frame, const Config& config);

/// A ray along d from o, with d's reciprocals.
Ray make_ray(const Vec3i& o, const Vec3i& d, const Config& config);

/// The direction alone.
Vec3i pixel_direction(std::uint32_t x, std::uint32_t y, const Frame& frame);

/// Bit length of |d| and floor(2^(M+R-1) / (|d| << (M - len))); (1, 0) for d = 0.
struct Recip {
    std::uint32_t recip = 1, len = 0;
};
Recip reciprocal(std::int32_t d, const Config& config);

} // namespace rayclock
