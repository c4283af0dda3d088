// The unit slant: crossings of planes, and the exits that a ray meets.
#include "model/engine/bsp/slant.hpp"

#include <algorithm>
#include <bit>

namespace rayclock {

namespace {

/// Returns the highest crossing_bits of a number.
std::int64_t cut_off(std::int64_t a, int len) {
    return len > crossing_bits ? a >> (len - crossing_bits) : a << (crossing_bits - len);
}
int bit_length(std::int64_t a) { return int(std::bit_width(std::uint64_t(a))); }

/// Returns floor(a 2^x), at most `most`.
std::uint32_t moved(std::int64_t a, int x, std::uint32_t most) {
    if (x <= 0) return std::uint32_t(std::min<std::int64_t>(x > -63 ? a >> -x : 0, most));
    return bit_length(a) + x > bit_length(most) ? most : std::uint32_t(a << x);
}

}   // namespace

WideSlant widen(const Slant& slant, int node_width) {
    WideSlant wide(slant, node_width);
    for (std::size_t i = 0; i + 1 < std::size_t(node_width); ++i) {
        for (std::size_t k = 0; k < 3; ++k) wide.normal[i][k] = slant.normal[3 * i + k];
        wide.at[i] = slant.at[i];
    }
    return wide;
}

Vec3i slant_direction(const Ray& ray, const Config& config) {
    if (ray.kind == RayKind::shadow) return ray.d;
    Vec3i d{};
    for (std::size_t k = 0; k < 3; ++k) d[k] = ray.d[k] * (1 << (config.ray_dir_bits() - config.dir_bits));
    return d;
}

PlaneSides crossing(const Vec3i& o, const Vec3i& along, const Vec3i& normal, std::int32_t at,
                    const Config& c) {
    const int frac = c.origin_frac();
    std::int64_t num = std::int64_t(at) * (1 << frac), den = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        num -= std::int64_t(normal[k]) * o[k];
        den += std::int64_t(normal[k]) * along[k];
    }
    PlaneSides sides;
    const std::uint32_t beyond = (1u << c.t_bits()) - 1;
    sides.near_to = beyond;
    if (den == 0) {
        sides.near = num >= 0;
        sides.far = num <= 0;
        return sides;
    }
    sides.turned = den < 0;
    if (sides.turned) num = -num, den = -den;
    sides.near = num > 0;
    if (!sides.near) return sides;
    const int num_len = bit_length(num), den_len = bit_length(den);
    const std::int64_t q = (cut_off(num, num_len) << (crossing_bits - 1)) / cut_off(den, den_len);
    const int x = c.t_frac_bits + c.ray_dir_bits() - frac - crossing_bits + num_len - den_len;
    sides.far_from = moved(q - 2, x, beyond);
    sides.near_to = moved(q + 2, x, beyond - 1) + 1;
    return sides;
}

std::uint32_t slant_exits(const BoxRay& ray, const Vec3i& along, const WideSlant& slant, const Config& c,
                          std::uint32_t* t_near) {
    AllSides sides;
    for (std::size_t i = 0; i + 1 < std::size_t(c.node_width); ++i)
        sides[i] = crossing(ray.o, along, slant.normal[i], slant.at[i], c);
    return exits_met(ray, slant, sides, c, t_near);
}

NodeAnswer slant(const SlantReq& req, const Config& config) {
    const WideSlant wide = widen(req.node, config.node_width);
    BoxRay ray{req.o, {}, req.recip, req.len};
    for (std::size_t k = 0; k < 3; ++k) ray.neg[k] = req.along[k] < 0;
    std::array<std::uint32_t, max_width> t_near;
    const std::uint32_t hits = slant_exits(ray, req.along, wide, config, t_near.data());
    return node_answer(req.ray, hits, t_near.data(), wide.exits);
}

}   // namespace rayclock
