#include "model/raygen/raygen.hpp"

#include <bit>
#include <cstdlib>

#include "model/isect/sheared.hpp"

namespace rayclock {

Recip reciprocal(std::int32_t d, const Config& config) {
    if (d == 0) return {};
    const std::uint32_t magnitude = std::uint32_t(std::abs(d));
    const int len = std::bit_width(magnitude);
    const std::uint32_t m = magnitude << (config.dir_bits - len);   // M bits, top bit set
    // Exact: a quotient that is no whole number misses the next one by 1 / m at least, far more than a double rounds.
    const double power = double(std::uint64_t(1) << (config.dir_bits + config.recip_bits - 1));
    return {std::uint32_t(std::int64_t(power / double(m))), std::uint32_t(len)};
}

Vec3i pixel_direction(std::uint32_t x, std::uint32_t y, const Frame& frame) {
    Vec3i d{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t sum = frame.corner[k] + x * frame.right[k] + y * frame.down[k];
        d[k] = std::int32_t((sum + (std::int64_t(1) << (guard_bits - 1))) >> guard_bits);
    }
    return d;
}

Ray make_ray(const Vec3i& o, const Vec3i& d, const Config& config) {
    Ray ray;
    ray.o = o;
    ray.d = d;
    for (std::size_t k = 0; k < 3; ++k) {
        const Recip r = reciprocal(d[k], config);
        ray.recip[k] = r.recip;
        ray.len[k] = r.len;
    }
    if (config.is_sheared()) ray.shear = shear_of(ray.d, config);
    return ray;
}

Ray raygen(const Slot& slot, const Frame& frame, const Config& config) {
    Ray ray = make_ray(frame.eye, pixel_direction(slot.x, slot.y, frame), config);
    ray.ray = slot.ray;
    return ray;
}

} // namespace rayclock
