#pragma once
#include "model/core/payloads.hpp"

namespace rayclock {

/// A ray that shade asks for, with the reciprocals of its direction rounded down. If it is a camera ray, it
/// begins at the eye and goes through the middle of its sample of pixel (x, y); any other has the origin and
/// the direction that were given.
///
/// Its direction is what Frame says: the sum of the pixel's steps, moved up by a power of two until it fills
/// M bits, and rounded. Mirror of rtl/unit/raygen/rc_raygen.sv, latency Config::raygen_latency() + 1, one ray
/// per cycle.
Ray spawn_ray(const Spawn& spawn, const Frame& frame, const Config& config);

/// Camera ray of a context's new pixel: through its middle, or its first sample.
Ray raygen(const Slot& slot, const Frame& frame, const Config& config);

/// A ray along d from o (with B fraction bits if the chip shades), with d's reciprocals.
Ray make_ray(const Vec3i& o, const Vec3i& d, const Config& config, RayKind kind = RayKind::camera);

/// The direction alone: of the pixel's middle, and of a sample.
Vec3i pixel_direction(std::uint32_t x, std::uint32_t y, const Frame& frame, const Config& config);
Vec3i sample_direction(std::uint32_t x, std::uint32_t y, std::uint32_t sample, const Frame& frame,
                       const Config& config);

/// A lattice point as a ray's origin.
Vec3i ray_origin(const Vec3i& point, const Config& config);

/// Bit length of |d| and floor(2^(M+R-1) / (|d| << (M - len))); (1, 0) for d = 0. M is ray_dir_bits().
struct Recip {
    std::uint32_t recip = 1, len = 0;
};
Recip reciprocal(std::int32_t d, const Config& config);

}   // namespace rayclock
