#pragma once
// The unit raygen: rays with their reciprocal directions.
#include "model/core/payloads.hpp"

namespace rayclock {

/// Returns the ray that shade requests, with the reciprocals of its direction rounded down. A camera ray
/// begins at the eye and passes through the middle of its sample of pixel (x, y). Any other ray has the given
/// origin and direction.
///
/// Frame defines a camera ray's direction: the sum of the pixel's steps, shifted up until it fills M bits,
/// and rounded. Mirror of rtl/unit/raygen/rc_raygen.sv, latency Config::raygen_latency() + 1, one ray every
/// Config::raygen_interval cycles.
Ray spawn_ray(const Spawn& spawn, const Frame& frame, const Config& config);

/// Returns the camera ray of a context's new pixel, through the pixel's middle or its first sample.
Ray raygen(const Slot& slot, const Frame& frame, const Config& config);

/// Returns a ray along d from o (with B fraction bits if the chip shades), with d's reciprocals.
Ray make_ray(const Vec3i& o, const Vec3i& d, const Config& config, RayKind kind = RayKind::camera);

/// Returns the ray of a stream's record, for a chip whose rays come from memory.
Ray recorded_ray(const RayRecord& record, std::uint32_t context, const Config& config);

/// Return only the direction, through a pixel's middle and through a sample.
Vec3i pixel_direction(std::uint32_t x, std::uint32_t y, const Frame& frame, const Config& config);
Vec3i sample_direction(std::uint32_t x, std::uint32_t y, std::uint32_t sample, const Frame& frame,
                       const Config& config);

/// Returns a lattice point as a ray's origin.
Vec3i ray_origin(const Vec3i& point, const Config& config);

/// Bit length of |d| and floor(2^(M+R-1) / (|d| << (M - len))); recip 1, len 0 for d = 0. Here M is
/// ray_dir_bits().
struct Recip {
    std::uint32_t recip = 1, len = 0;
};
Recip reciprocal(std::int32_t d, const Config& config);

}   // namespace rayclock
