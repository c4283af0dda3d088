#pragma once
// Requests for treelet, and the judgement of its answers and of slant's by exact geometry.
#include "tests/support/oracle/fractions.hpp"
#include "tests/support/cases/ends.hpp"
#include "tests/support/world/traffic.hpp"

namespace rayclock::test {

/// A request, and the direction of its reciprocals.
struct TreeletCase {
    TreeletReq req;
    Vec3i d{};
    bool is_long = false;   ///< d fills ray_dir_bits, like a shadow ray's, instead of dir_bits
};

/// Sets the reciprocals that raygen computes from the direction.
template <class Case> void set_reciprocals(Case& c, const Config& config) {
    for (std::size_t k = 0; k < 3; ++k) {
        const int d = c.d[k];
        c.req.len[k] = std::uint32_t(oracle::digits(d));
        if (d != 0 && !c.is_long) c.req.len[k] += std::uint32_t(config.ray_dir_bits() - config.dir_bits);
        c.req.recip[k] =
            d == 0 ? 1 : std::uint32_t(oracle::floor(oracle::scaled_reciprocal(d, config.recip_bits)));
    }
}

/// Half of the rays aim at planes, their edges and corners.
inline TreeletCase random_treelet_case(Draw& draw, const Config& config) {
    TreeletCase c;
    const int frac = config.origin_frac(), n = config.coord_bits;
    const auto kind = RayKind(config.shading ? draw.below(3) : 0);
    c.is_long = kind == RayKind::shadow;
    const int bits = c.is_long ? config.ray_dir_bits() : config.dir_bits;
    c.req.ray = std::uint32_t(draw.natural(config.ray_bits()));
    const Vec3i near = draw.vector(n);
    Treelet& t = c.req.node;
    t.base = std::uint32_t(draw.natural(max_addr_bits));
    const int reach = 1 << draw.below(n);
    for (std::size_t i = 0; i + 1 < std::size_t(config.node_width); ++i) {
        t.axis[i] = draw.below(8) == 0 ? no_axis : std::uint32_t(draw.below(3));
        t.at[i] = (draw.coin() ? draw.vector(n) : draw.near(near, reach, n))[t.axis[i] % 3];
    }
    for (std::size_t i = 0; i < std::size_t(config.node_width); ++i) t.kind[i] = std::uint32_t(draw.below(8));
    t.open = draw.below(4) == 0;
    t.lo = draw.near(near, reach, n);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t up = std::int64_t(t.lo[k]) + (draw.below(4) == 0 ? 0 : draw.below(2 * reach));
        t.hi[k] = std::int32_t(std::min<std::int64_t>(up, (std::int64_t(1) << (n - 1)) - 1));
    }
    Vec3i d = draw.vector(bits);
    for (std::size_t k = 0; k < 3; ++k) {
        c.req.o[k] = near[k] * (1 << frac);
        if (kind != RayKind::bounce) continue;
        c.req.o[k] += int(draw.natural(frac));
        const auto i = std::size_t(draw.below(config.node_width - 1));
        if (draw.below(4) == 0 && t.axis[i] == k)   // starts on a plane
            c.req.o[k] = t.at[i] * (1 << frac);
    }
    if (draw.percent(60)) {
        const int factor = 1 << draw.below(4);
        const std::int64_t most = (std::int64_t(1) << (bits - 1)) - 1;
        for (std::size_t i = 0; i + 1 < std::size_t(config.node_width); ++i) {
            const std::size_t k = t.axis[i] % 3;
            const std::int64_t way = std::int64_t(t.at[i]) - near[k];
            d[k] = std::int32_t(std::clamp(way * factor, -most - 1, most));
        }
    }
    if (draw.below(4) == 0) d[std::size_t(draw.below(3))] >>= draw.below(bits);   // any length
    if (draw.below(3) == 0) d[std::size_t(draw.below(3))] = 0;
    c.d = d;
    set_reciprocals(c, config);
    for (std::size_t k = 0; k < 3; ++k) c.req.neg[k] = d[k] < 0;
    return c;
}

/// Draws only small operands and operands at both ends of their widths. Planes lie at the ray's origin or a
/// step next to it. Rays do not move along some axes. Distances and reciprocals are short or as long as
/// possible.
inline TreeletCase treelet_case_at_ends(Draw& draw, const Config& config) {
    TreeletCase c;
    const int frac = config.origin_frac(), n = config.coord_bits;
    const auto kind = RayKind(config.shading ? draw.below(3) : 0);
    c.is_long = kind == RayKind::shadow;
    c.req.ray = std::uint32_t(draw.natural(config.ray_bits()));
    const Vec3i near = vector_at_ends(draw, n);
    Treelet& t = c.req.node;
    t.base = std::uint32_t(draw.natural(max_addr_bits));
    for (std::size_t i = 0; i + 1 < std::size_t(config.node_width); ++i) {
        t.axis[i] = std::uint32_t(draw.below(3));
        t.at[i] = draw.coin() ? vector_at_ends(draw, n)[t.axis[i]] : draw.near(near, 2, n)[t.axis[i]];
    }
    for (std::size_t i = 0; i < std::size_t(config.node_width); ++i) t.kind[i] = std::uint32_t(draw.below(8));
    t.open = draw.coin();
    const Vec3i a = vector_at_ends(draw, n), b = vector_at_ends(draw, n);
    c.d = vector_at_ends(draw, c.is_long ? config.ray_dir_bits() : config.dir_bits);
    for (std::size_t k = 0; k < 3; ++k) {
        t.lo[k] = std::min(a[k], b[k]), t.hi[k] = std::max(a[k], b[k]);
        c.req.o[k] = near[k] * (1 << frac);
        if (kind == RayKind::bounce) c.req.o[k] += int(draw.natural(frac));
        c.req.neg[k] = c.d[k] < 0;
    }
    set_reciprocals(c, config);
    return c;
}

/// The times at which a ray is in an exit's closed cell, in units of t. The `grown` times include the largest
/// rounding errors.
struct ExitTimes {
    bool there = true;
    oracle::Rational enter = 0, leave = -1, grown_enter = 0, grown_leave = -1;   ///< -1 means never

    /// Cuts the times by one side of a plane. The plane is `num` ahead of the origin, and the ray approaches
    /// it by `den` per unit of its direction; `upper` selects the side. `unit` is the number of such units in
    /// one of t. `loose_of` returns what rounding may add to a time.
    template <class Loose> void cut(const oracle::Rational& num, const oracle::Int& den, bool upper,
                                    const oracle::Rational& unit, Loose&& loose_of) {
        if (den == 0) {
            there = there && (upper ? num <= 0 : num >= 0);
            return;
        }
        const oracle::Rational time = num / den * unit, loose = loose_of(time);
        if (upper == (den < 0)) {   // the side that the ray enters first
            if (time <= 0) there = false;
            if (leave < 0 || time < leave) leave = time;
            if (grown_leave < 0 || time + loose < grown_leave) grown_leave = time + loose;
        } else {
            enter = std::max(enter, time);
            grown_enter = std::max(grown_enter, oracle::Rational(time - loose));
        }
    }
    bool is_met() const { return there && leave != 0 && (leave < 0 || enter <= leave); }
    /// Times beyond the largest one are all equal.
    bool may_be_met(const oracle::Int& beyond) const {
        return there && (grown_leave < 0 || grown_enter <= grown_leave || grown_leave >= beyond);
    }
};

/// Calls `planes` with the times, to cut them, and with side(), which cuts them by a plane across an axis.
template <class Case, class Line, class Planes>
ExitTimes exit_times(const Case& c, const Line& t, const Config& config, Planes&& planes) {
    using oracle::Rational;
    ExitTimes times;
    const int frac = config.origin_frac(), bits = c.is_long ? config.ray_dir_bits() : config.dir_bits;
    const auto side = [&](std::uint32_t k, std::int32_t at, bool upper) {
        const Rational way =
            Rational(oracle::Int(at)) - Rational(oracle::Int(c.req.o[k]), oracle::Int(1) << frac);
        const oracle::Int d = c.d[k];
        const Rational unit = oracle::power_of_two(bits - 1 + config.t_frac_bits);
        // The tolerance: one step of distance, 1 of a reciprocal of R bits, and rounding to whole units. The
        // side that the ray leaves counts a step as up to two, and is rounded twice (docs/proofs/planes.md).
        const int most = upper == (d < 0) ? 2 : 1;
        times.cut(way, d, upper, unit, [&](const Rational& time) {
            const Rational step = unit / abs(d);
            return Rational((abs(time) + step) * oracle::power_of_two(1 - config.recip_bits) +
                            (frac > 0 ? most * step : Rational(0)) + most);
        });
    };
    for (std::uint32_t k = 0; k < 3 && !t.open; ++k) side(k, t.lo[k], true), side(k, t.hi[k], false);
    planes(times, side);
    return times;
}

/// Visits the planes on the path to an exit, and the exit's side of each.
template <class See> void for_each_plane(std::size_t exit, const Config& config, See&& see) {
    std::size_t plane = 0;
    for (std::size_t half = std::size_t(config.node_width) / 2; half > 0; half /= 2) {
        const bool upper = exit & half;
        see(plane, upper);
        plane = 2 * plane + 1 + upper;
    }
}

inline ExitTimes exit_times(const TreeletCase& c, std::size_t exit, const Config& config) {
    const Treelet& t = c.req.node;
    return exit_times(c, t, config, [&](ExitTimes&, auto&& side) {
        for_each_plane(exit, config, [&](std::size_t plane, bool upper) {
            if (t.axis[plane] != no_axis) side(t.axis[plane], t.at[plane], upper);
        });
    });
}

/// Requires that no exit that the ray meets is missing, and that t_near is never beyond the entry. Every
/// other exit must meet exact planes moved by the rounding errors. Inner exits come first, each part sorted
/// by (t_near, offset). The rest is zero.
template <class Case, class Line>
void judge(const Case& c, const Line& t, const NodeAnswer& rsp, const Config& config) {
    const oracle::Int beyond = (oracle::Int(1) << config.t_bits()) - 1;
    const auto width = std::size_t(config.node_width);
    std::uint32_t lines = 0, primitives = 0, before = 0, found = 0;
    for (std::size_t i = 0; i < width; ++i) lines += t.kind[i] == 1;
    for (std::size_t i = 0; i < width; ++i) {
        if (t.kind[i] == 0) continue;
        const bool inner = t.kind[i] == 1;
        const std::uint32_t offset = inner ? 2 * before++ : 2 * lines + primitives, count = t.kind[i] - 1;
        if (!inner) primitives += count;
        const ExitTimes exact = exit_times(c, i, config);
        std::optional<std::uint32_t> said;
        for (std::size_t n = inner ? 0 : rsp.inner; n < (inner ? rsp.inner : rsp.inner + rsp.leaves); ++n)
            if (rsp.offset[n] == offset && rsp.count[n] == count) said = rsp.t_near[n];
        CAPTURE(i, offset, c.d[0], c.d[1], c.d[2]);
        if (exact.is_met()) REQUIRE(said);
        if (exact.is_met()) REQUIRE(*said <= std::min(oracle::floor(exact.enter), beyond));
        if (said) REQUIRE(exact.may_be_met(beyond));
        if (said) REQUIRE(*said >= std::min(oracle::floor(exact.grown_enter), beyond));
        found += said.has_value();
    }
    REQUIRE(found == rsp.inner + rsp.leaves);
    REQUIRE(rsp.ray == c.req.ray);
    REQUIRE(rsp.base == t.base);
    for (std::size_t n = 0; n < max_width; ++n) {
        if (n >= found) REQUIRE((rsp.t_near[n] == 0 && rsp.offset[n] == 0 && rsp.count[n] == 0));
        if (n == 0 || n == rsp.inner || n >= found) continue;
        REQUIRE(std::pair(rsp.t_near[n - 1], rsp.offset[n - 1]) < std::pair(rsp.t_near[n], rsp.offset[n]));
    }
}

inline void judge(const TreeletCase& c, const NodeAnswer& rsp, const Config& config) {
    judge(c, c.req.node, rsp, config);
}

}   // namespace rayclock::test
