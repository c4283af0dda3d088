#pragma once
// Requests for globe, and the judgement of its answers by exact geometry.
#include <algorithm>
#include <cmath>

#include "model/engine/spheres/globe.hpp"
#include "tests/support/oracle/fractions.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "tests/support/cases/ends.hpp"
#include "tests/support/world/traffic.hpp"

namespace rayclock::test {

/// A request, and the ray from which it was made.
struct GlobeCase {
    GlobeReq req;
    Ray ray;
};

/// Half of the rays aim at a globe's centre, or at about its radius away from it.
inline GlobeCase random_globe_case(Draw& draw, const Config& config) {
    GlobeCase c;
    const int n = config.coord_bits, frac = config.origin_frac();
    GlobeNode& node = c.req.node;
    const Vec3i near = draw.vector(n);
    node.base = std::uint32_t(draw.natural(config.addr_bits));
    node.org = draw.coin() ? draw.vector(n) : draw.near(near, 1 << draw.below(n), n);
    node.exp = std::uint32_t(draw.below(n - globe_bits + 2));
    const auto width = std::size_t(config.node_width);
    std::uint32_t inner = std::uint32_t(draw.below(int(width) + 1));
    for (std::size_t i = 0; i < width; ++i) {
        node.kind[i] = i < inner ? 1u : std::uint32_t(draw.below(7));
        if (node.kind[i] == 1) node.kind[i] = 0;
        if (i < inner) node.kind[i] = 1;
        if (i > 0 && node.kind[i - 1] == 0) node.kind[i] = 0;
        node.radius[i] = std::uint32_t(draw.natural(draw.below(globe_bits) + 1));
        for (std::size_t k = 0; k < 3; ++k)
            node.centre[3 * i + k] = std::uint32_t(draw.natural(draw.below(globe_bits) + 1));
    }
    const auto kind = RayKind(config.shading ? draw.below(3) : 0);
    const int bits = kind == RayKind::shadow ? config.ray_dir_bits() : config.dir_bits;
    Vec3i o, d = draw.vector(bits);
    for (std::size_t k = 0; k < 3; ++k)
        o[k] = near[k] * (1 << frac) + (kind == RayKind::bounce ? int(draw.natural(frac)) : 0);
    if (draw.percent(60)) {
        const auto i = std::size_t(draw.below(int(width)));
        const std::int64_t most = (std::int64_t(1) << (bits - 1)) - 1, factor = 1 << draw.below(4);
        const int radius = int(node.radius[i] << node.exp);
        for (std::size_t k = 0; k < 3; ++k) {
            std::int64_t way = node.org[k] + (std::int64_t(node.centre[3 * i + k]) << node.exp) - near[k];
            if (draw.percent(70)) way += draw.between(-radius, radius);
            d[k] = std::int32_t(std::clamp<std::int64_t>(way * factor, -most - 1, most));
        }
    }
    if (draw.below(4) == 0) d[std::size_t(draw.below(3))] = 0;
    if (d == Vec3i{}) d[0] = -1;
    c.ray = make_ray(o, d, config, kind);
    const GlobeRay ray = globe_ray(c.ray, config);
    c.req.ray = std::uint32_t(draw.natural(config.ray_bits()));
    c.req.o = ray.o, c.req.toward = ray.toward, c.req.len = ray.len;
    return c;
}

/// Draws only small operands and operands at both ends of their widths. Radii are zero, one or as large as
/// possible; moments have either sign; directions round up to a power of two.
inline GlobeCase globe_case_at_ends(Draw& draw, const Config& config) {
    GlobeCase c;
    const int frac = config.origin_frac();
    GlobeNode& node = c.req.node;
    node.base = std::uint32_t(draw.natural(config.addr_bits));
    node.org = vector_at_ends(draw, config.coord_bits);
    node.exp = std::uint32_t(draw.coin() ? 0 : draw.below(config.coord_bits - globe_bits + 2));
    const auto end = [&] {   // of an unsigned number
        return std::uint32_t(at_an_end(draw, globe_bits)) & ((1u << globe_bits) - 1);
    };
    const auto width = std::uint32_t(config.node_width), inner = std::uint32_t(draw.below(int(width) + 1));
    for (std::uint32_t i = 0; i < width; ++i) {
        node.kind[i] = i < inner ? 1 : std::uint32_t(2 + draw.below(6));
        node.radius[i] = end();
        for (std::size_t k = 0; k < 3; ++k) node.centre[3 * i + k] = end();
    }
    const auto kind = RayKind(config.shading ? draw.below(3) : 0);
    const int bits = kind == RayKind::shadow ? config.ray_dir_bits() : config.dir_bits;
    Vec3i o = vector_at_ends(draw, config.coord_bits), d = vector_at_ends(draw, bits);
    for (auto& x : o) x = x * (1 << frac) + (kind == RayKind::bounce ? int(draw.natural(frac)) : 0);
    if (draw.coin())   // one less than a power of two
        for (auto& x : d) x = ((1 << draw.below(bits)) - 1) * (draw.coin() ? 1 : -1);
    if (d == Vec3i{}) d[0] = -1;
    c.ray = make_ray(o, d, config, kind);
    const GlobeRay ray = globe_ray(c.ray, config);
    c.req.ray = std::uint32_t(draw.natural(config.ray_bits()));
    c.req.o = ray.o, c.req.toward = ray.toward, c.req.len = ray.len;
    return c;
}

/// A globe and a ray in fractions: v is the vector from the origin to the centre.
struct GlobeSight {
    oracle::Rational dd = 0, dv = 0, vv = 0, radius = 0;
    double unit = 0, away = 0, step = 0;   ///< units of t for a ray of length 1; sum of |v|; 2^exp

    /// Returns true if the ray has a point with s >= 0 in the globe enlarged by `more`.
    bool is_met(const oracle::Rational& more = 0) const {
        const oracle::Rational r = radius + more, c = vv - r * r;
        return c <= 0 || (dv >= 0 && dv * dv >= dd * c);
    }
    /// Returns true if s is not after the first such point, which exists: sqrt(dv^2 - dd c) <= dv - dd s.
    bool is_before(const oracle::Rational& s) const {
        const oracle::Rational c = vv - radius * radius, rest = dv - dd * s;
        return s == 0 || (rest >= 0 && dv * dv - dd * c <= rest * rest);
    }
    /// Returns the approximate entry of the ray into the globe enlarged by `more`.
    double enters(double more) const {
        const double d = dd.convert_to<double>(), v = dv.convert_to<double>(),
                     r = radius.convert_to<double>() + more, c = vv.convert_to<double>() - r * r;
        return (v - std::sqrt(std::max(0.0, v * v - d * c))) / d;
    }
};
inline GlobeSight sight_of(const GlobeCase& c, std::size_t i, const Config& config) {
    using oracle::Rational;
    GlobeSight sight;
    const GlobeNode& node = c.req.node;
    const oracle::Int step = oracle::Int(1) << node.exp;
    for (std::size_t k = 0; k < 3; ++k) {
        const Rational v = Rational(oracle::Int(node.org[k]) + node.centre[3 * i + k] * step) -
                           Rational(oracle::Int(c.ray.o[k]), oracle::Int(1) << config.origin_frac());
        const Rational d = oracle::Int(c.ray.d[k]);
        sight.dd += d * d, sight.dv += d * v, sight.vv += v * v;
        sight.away += std::abs(v.convert_to<double>());
    }
    sight.radius = node.radius[i] * step;
    sight.step = step.convert_to<double>();
    return sight;
}

/// Requires that no globe that the ray meets is missing and that t_near is never beyond the entry. Extra
/// globes and early times must be explained by the roundings. Inner children come first, each part sorted by
/// (t_near, offset). The rest is zero.
inline void judge(const GlobeCase& c, const NodeAnswer& rsp, const Config& config, bool is_tight = true) {
    using oracle::Rational;
    const GlobeNode& node = c.req.node;
    const bool is_long = c.ray.kind == RayKind::shadow;
    const int bits = is_long ? config.ray_dir_bits() : config.dir_bits;
    const Rational unit = oracle::power_of_two(bits - 1 + config.t_frac_bits);
    const oracle::Int beyond = (oracle::Int(1) << config.t_bits()) - 1;
    std::uint32_t inner = 0, primitives = 0, found = 0;
    for (std::size_t i = 0; i < std::size_t(config.node_width); ++i) inner += node.kind[i] == 1;
    for (std::size_t i = 0; i < std::size_t(config.node_width); ++i) {
        if (node.kind[i] == 0) continue;
        const bool is_inner = node.kind[i] == 1;
        const std::uint32_t count = node.kind[i] - 1,
                            offset = is_inner ? 2 * std::uint32_t(i) : 2 * inner + primitives;
        primitives += count;
        const GlobeSight exact = sight_of(c, i, config);
        std::optional<std::uint32_t> said;
        for (std::size_t n = is_inner ? 0 : rsp.inner; n < (is_inner ? rsp.inner : rsp.inner + rsp.leaves);
             ++n)
            if (rsp.offset[n] == offset && rsp.count[n] == count) said = rsp.t_near[n];
        CAPTURE(i, offset, c.ray.d[0], c.ray.d[1], c.ray.d[2]);
        const bool met = exact.is_met();
        if (met) REQUIRE(said);
        if (met) REQUIRE(exact.is_before(oracle::Int(*said) / unit));
        if (!said) continue;
        ++found;
        if (!is_tight) continue;
        const double slack = exact.radius.convert_to<double>() / 4096 + exact.away / 32768 + exact.step + 1 +
                             (config.shading ? 16 + 16 * exact.step : 0);
        REQUIRE(exact.is_met(Rational(slack)));
        const double length = std::sqrt(exact.dd.convert_to<double>()), to_t = unit.convert_to<double>();
        const double enters = std::max(0.0, exact.enters(slack)),
                     loose = (0.02 * (exact.radius.convert_to<double>() + slack) + slack) / length;
        const double least =
            std::min((enters * (1 - 1.0 / 8192) - loose) * to_t - 2, beyond.convert_to<double>());
        REQUIRE(double(*said) >= least);
    }
    REQUIRE(found == rsp.inner + rsp.leaves);
    REQUIRE(rsp.ray == c.req.ray);
    REQUIRE(rsp.base == node.base);
    for (std::size_t n = 0; n < max_width; ++n) {
        if (n >= found) REQUIRE((rsp.t_near[n] == 0 && rsp.offset[n] == 0 && rsp.count[n] == 0));
        if (n == 0 || n == rsp.inner || n >= found) continue;
        REQUIRE(std::pair(rsp.t_near[n - 1], rsp.offset[n - 1]) < std::pair(rsp.t_near[n], rsp.offset[n]));
    }
}

}   // namespace rayclock::test
