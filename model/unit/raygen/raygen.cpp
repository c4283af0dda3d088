// Camera rays, and the reciprocals of all rays' directions.
#include "model/unit/raygen/raygen.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "model/scene/whitted.hpp"
#include "model/unit/tri/sheared.hpp"

namespace rayclock {

Recip reciprocal(std::int32_t d, const Config& config) {
    if (d == 0) return {};
    const int bits = config.ray_dir_bits();
    const std::uint32_t magnitude = std::uint32_t(std::abs(d));
    const int len = std::bit_width(magnitude);
    const std::uint32_t m = magnitude << (bits - len);   // same width for all, top bit set
    // Exact: |d| is 2^(M-1) or shorter than M bits, so m divides exactly or is even. A quotient that is not a
    // whole number then misses the next one by at least 2 / m > 2^(1-M). A double below 2^R rounds by at most
    // 2^(R-54), which suffices as M + R <= 31 + 24.
    const double power = double(std::uint64_t(1) << (bits + config.recip_bits - 1));
    return {std::uint32_t(std::int64_t(power / double(m))), std::uint32_t(len)};
}

namespace {

/// Returns the direction through the point (x, y), in pixels with `frac` fraction bits.
Vec3i direction_of(std::int64_t x, std::int64_t y, int frac, const Frame& frame, const Config& config) {
    Vec3l sum{};
    std::uint64_t used = 0;   // bits that differ from the sign, in any component
    for (std::size_t k = 0; k < 3; ++k) {
        sum[k] = (frame.corner[k] << frac) + x * frame.right[k] + y * frame.down[k];
        used |= std::uint64_t(sum[k] ^ sum[k] >> 63);
    }
    const int drop = guard_bits + frac,
              shift = std::clamp(config.dir_bits - 1 + drop - int(std::bit_width(used)), 0, max_shift);
    const std::int32_t most = (1 << (config.dir_bits - 1)) - 1,
                       least = config.has_instances() ? -most : -most - 1;   // a mirror needs its opposite
    Vec3i d{};
    for (std::size_t k = 0; k < 3; ++k)
        d[k] = std::clamp(std::int32_t(((sum[k] << shift) + (std::int64_t(1) << (drop - 1))) >> drop), least,
                          most);
    return d;
}

}   // namespace

Vec3i pixel_direction(std::uint32_t x, std::uint32_t y, const Frame& frame, const Config& config) {
    return direction_of(x, y, 0, frame, config);
}

Vec3i sample_direction(std::uint32_t x, std::uint32_t y, std::uint32_t sample, const Frame& frame,
                       const Config& config) {
    if (!config.supersampling) return pixel_direction(x, y, frame, config);
    const ShadeFrame& s = frame.shade;
    const SampleOffset offset = sample_offset(x, y, sample, int(s.side), s.jitter != 0, s.seed);
    return direction_of((std::int64_t(x) << sub_pixel_bits) + offset.x,
                        (std::int64_t(y) << sub_pixel_bits) + offset.y, sub_pixel_bits, frame, config);
}

Vec3i ray_origin(const Vec3i& point, const Config& config) {
    Vec3i o;
    for (std::size_t k = 0; k < 3; ++k) o[k] = point[k] * (1 << config.origin_frac());
    return o;
}

Ray make_ray(const Vec3i& o, const Vec3i& d, const Config& config, RayKind kind) {
    Ray ray;
    ray.o = o;
    ray.d = d;
    ray.kind = kind;
    const auto shorter = std::uint32_t(kind == RayKind::shadow ? 0 : config.ray_dir_bits() - config.dir_bits);
    for (std::size_t k = 0; k < 3; ++k) {
        const Recip r = reciprocal(d[k], config);
        ray.recip[k] = r.recip;
        ray.len[k] = r.len != 0 ? r.len + shorter : 0;
    }
    if (config.is_sheared()) ray.shear = shear_of(ray.d, config);
    return ray;
}

Ray spawn_ray(const Spawn& spawn, const Frame& frame, const Config& config) {
    Ray ray = spawn.kind == RayKind::camera
                  ? make_ray(ray_origin(frame.eye, config),
                             sample_direction(spawn.x, spawn.y, spawn.sample, frame, config), config)
                  : make_ray(spawn.o, spawn.d, config, spawn.kind);
    ray.ray = spawn.ray;
    ray.self = spawn.self;
    ray.is_inside = spawn.is_inside;
    ray.is_partial = spawn.is_partial;
    ray.holes = spawn.holes;
    ray.home = spawn.home;
    return ray;
}

Ray recorded_ray(const RayRecord& record, std::uint32_t context, const Config& config) {
    Ray ray = make_ray(record.o, record.d, config, record.kind);
    ray.ray = context;
    return ray;
}

Ray raygen(const Slot& slot, const Frame& frame, const Config& config) {
    Spawn spawn;
    spawn.ray = slot.ray;
    spawn.x = slot.x;
    spawn.y = slot.y;
    return spawn_ray(spawn, frame, config);
}

}   // namespace rayclock
