#pragma once
// Requests for slant, and the judgement of its answers by exact geometry.
#include "model/engine/bsp/slant.hpp"
#include "tests/support/cases/treelet_cases.hpp"

namespace rayclock::test {

/// A request, and the direction that raygen received.
struct SlantCase {
    SlantReq req;
    Vec3i d{};
    bool is_long = false;   ///< as in TreeletCase
};

inline std::int64_t across(const Vec3i& n, const Vec3i& x) {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += std::int64_t(n[k]) * x[k];
    return sum;
}
inline Vec3i normal_of(const Slant& slant, std::size_t plane) {
    return {slant.normal[3 * plane], slant.normal[3 * plane + 1], slant.normal[3 * plane + 2]};
}

/// Sets all fields that follow from the ray's direction.
inline void set_direction(SlantCase& c, const Vec3i& d, const Config& config) {
    c.d = d;
    set_reciprocals(c, config);
    Ray ray;
    ray.d = d;
    ray.kind = c.is_long ? RayKind::shadow : RayKind::camera;
    c.req.along = slant_direction(ray, config);
}

/// Planes through points near the ray's origin. Rays lie in them, start on them, or aim at edges where two
/// planes meet.
inline SlantCase random_slant_case(Draw& draw, const Config& config) {
    SlantCase c;
    const int frac = config.origin_frac(), n = config.coord_bits;
    const auto kind = RayKind(config.shading ? draw.below(3) : 0);
    c.is_long = kind == RayKind::shadow;
    const int bits = c.is_long ? config.ray_dir_bits() : config.dir_bits;
    const std::int64_t most = (std::int64_t(1) << (bits - 1)) - 1;
    c.req.ray = std::uint32_t(draw.natural(config.ray_bits()));
    const Vec3i near = draw.vector(n);
    const int reach = 1 << draw.below(n);
    Slant& s = c.req.node;
    s.base = std::uint32_t(draw.natural(max_addr_bits));
    const auto planes = std::size_t(config.planes_of_node());
    const Vec3i meet = draw.near(near, reach, n);   // common to many planes
    for (std::size_t i = 0; i < planes; ++i) {
        Vec3i normal{};
        const int what = draw.below(8);
        if (what == 1) normal[std::size_t(draw.below(3))] = draw.coin() ? 1 : -1;
        if (what > 1) normal = draw.vector(what == 2 ? 2 : normal_step_bits);
        for (std::size_t k = 0; k < 3; ++k) s.normal[3 * i + k] = normal[k];
        const Vec3i through = draw.coin() ? meet : draw.below(4) == 0 ? near : draw.near(near, reach, n);
        s.at[i] = std::int32_t(across(normal, through)) + (draw.below(4) == 0 ? draw.between(-2, 2) : 0);
        if (draw.below(16) == 0) s.at[i] = std::int32_t(draw.number(config.offset_of_plane_bits()));
    }
    for (std::size_t i = 0; i < std::size_t(config.node_width); ++i) s.kind[i] = std::uint32_t(draw.below(8));
    s.open = draw.below(4) == 0;
    s.lo = draw.near(near, reach, n);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t up = std::int64_t(s.lo[k]) + (draw.below(4) == 0 ? 0 : draw.below(2 * reach));
        s.hi[k] = std::int32_t(std::min<std::int64_t>(up, (std::int64_t(1) << (n - 1)) - 1));
        c.req.o[k] = near[k] * (1 << frac);
        if (kind == RayKind::bounce && draw.coin()) c.req.o[k] += int(draw.natural(frac));
    }
    Vec3i d = draw.vector(bits);
    const auto take = [&](auto&& of) {
        for (std::size_t k = 0; k < 3; ++k)
            d[k] = std::int32_t(std::clamp<std::int64_t>(of(k), -most - 1, most));
    };
    const Vec3i a = normal_of(s, std::size_t(draw.below(int(planes)))),
                b = normal_of(s, std::size_t(draw.below(int(planes))));
    const int factor = 1 << draw.below(4);
    switch (draw.below(4)) {
        case 0: take([&](std::size_t k) { return (std::int64_t(meet[k]) - near[k]) * factor; }); break;
        case 1:   // along an edge, or within a plane
            take([&](std::size_t k) {
                const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
                return (std::int64_t(a[i]) * b[j] - std::int64_t(a[j]) * b[i]) * factor;
            });
            break;
        default: break;
    }
    if (draw.below(6) == 0) d[std::size_t(draw.below(3))] = 0;
    set_direction(c, d, config);
    return c;
}

/// Draws only small operands and operands at both ends of their widths. Dividends and divisors have a few
/// units or full length. Rays lie in planes and next to them, in the middle and in the corners of the
/// lattice.
inline SlantCase slant_case_at_ends(Draw& draw, const Config& config) {
    SlantCase c;
    const int frac = config.origin_frac(), n = config.coord_bits;
    const auto kind = RayKind(config.shading ? draw.below(3) : 0);
    c.is_long = kind == RayKind::shadow;
    c.req.ray = std::uint32_t(draw.natural(config.ray_bits()));
    const Vec3i near = vector_at_ends(draw, n);
    Slant& s = c.req.node;
    s.base = std::uint32_t(draw.natural(max_addr_bits));
    for (std::size_t i = 0; i < std::size_t(config.planes_of_node()); ++i) {
        const Vec3i normal = vector_at_ends(draw, normal_step_bits);
        for (std::size_t k = 0; k < 3; ++k) s.normal[3 * i + k] = normal[k];
        s.at[i] = std::int32_t(draw.below(4) == 0 ? at_an_end(draw, config.offset_of_plane_bits())
                                                  : across(normal, near) + draw.between(-2, 2));
    }
    for (std::size_t i = 0; i < std::size_t(config.node_width); ++i) s.kind[i] = std::uint32_t(draw.below(8));
    s.open = draw.coin();
    const Vec3i a = vector_at_ends(draw, n), b = vector_at_ends(draw, n);
    for (std::size_t k = 0; k < 3; ++k) {
        s.lo[k] = std::min(a[k], b[k]), s.hi[k] = std::max(a[k], b[k]);
        c.req.o[k] = near[k] * (1 << frac);
        if (kind == RayKind::bounce) c.req.o[k] += int(draw.natural(frac));
    }
    set_direction(c, vector_at_ends(draw, c.is_long ? config.ray_dir_bits() : config.dir_bits), config);
    return c;
}

inline ExitTimes exit_times(const SlantCase& c, std::size_t exit, const Config& config) {
    using oracle::Int;
    using oracle::Rational;
    const Slant& s = c.req.node;
    const int bits = c.is_long ? config.ray_dir_bits() : config.dir_bits;
    const Rational unit = oracle::power_of_two(bits - 1 + config.t_frac_bits);
    // 4 parts of a quotient of at least 2^16 - 2, and rounding to whole units.
    const Rational part(4, (1 << (crossing_bits - 2)) - 2);
    return exit_times(c, s, config, [&](ExitTimes& times, auto&&) {
        for_each_plane(exit, config, [&](std::size_t plane, bool upper) {
            Rational num = Int(s.at[plane]);
            Int den = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const Int n = s.normal[3 * plane + k];
                num -= Rational(n * c.req.o[k], Int(1) << config.origin_frac());
                den += n * c.d[k];
            }
            times.cut(num, den, upper, unit, [&](const Rational& time) { return Rational(time * part + 2); });
        });
    });
}
inline void judge(const SlantCase& c, const NodeAnswer& rsp, const Config& config) {
    judge(c, c.req.node, rsp, config);
}

}   // namespace rayclock::test
