#pragma once
// Requests for box, and the judgement of its answers by exact geometry.
#include "tests/support/oracle/fractions.hpp"
#include "tests/support/world/traffic.hpp"

namespace rayclock::test {

/// A request, and the direction of its reciprocals. If the chip shades, the origin has fraction bits.
struct BoxCase {
    BoxReq req;
    Vec3i d{};
    bool is_long = false;   ///< d fills ray_dir_bits, like a shadow ray's, instead of dir_bits
};

/// Sets neg, recip and len as raygen guarantees them.
inline void set_direction(BoxCase& c, const Vec3i& d, const Config& config) {
    c.d = d;
    for (std::size_t k = 0; k < 3; ++k) {
        c.req.neg[k] = d[k] < 0;
        c.req.len[k] = std::uint32_t(oracle::digits(d[k]));
        if (d[k] != 0 && !c.is_long) c.req.len[k] += std::uint32_t(config.ray_dir_bits() - config.dir_bits);
        c.req.recip[k] =
            d[k] == 0 ? 1 : std::uint32_t(oracle::floor(oracle::scaled_reciprocal(d[k], config.recip_bits)));
    }
}

/// Returns the child's box in steps of 2^-frac.
inline oracle::Box child_box(const Node& node, std::size_t child, int frac = 0) {
    oracle::Box box;
    for (std::size_t k = 0; k < 3; ++k) {
        const oracle::Int org = oracle::Int(node.org[k]) << frac;
        box.step[k] = oracle::Int(1) << (node.exp[k] + std::uint32_t(frac));
        box.lo[k] = org + node.lo[3 * child + k] * box.step[k];
        box.hi[k] = org + node.hi[3 * child + k] * box.step[k];
    }
    return box;
}

/// Draws a node with `children` children: first the inner ones, then leaves.
inline Node random_node(Draw& draw, const Config& config, const Vec3i& o) {
    Node node;
    const int reach = 1 << draw.below(config.coord_bits);
    node.org = draw.coin() ? draw.vector(config.coord_bits) : draw.near(o, reach, config.coord_bits);
    node.base = std::uint32_t(draw.natural(max_addr_bits));
    const int children = draw.between(1, config.node_width), inner = draw.between(0, children);
    for (std::size_t k = 0; k < 3; ++k)
        node.exp[k] = std::uint32_t(draw.below(config.coord_bits - config.box_bits + 2));
    for (std::size_t i = 0; i < std::size_t(children); ++i) {
        node.kind[i] = std::uint32_t(int(i) < inner ? 1 : draw.between(2, 7));
        for (std::size_t k = 0; k < 3; ++k) {
            auto lo = std::uint32_t(draw.natural(config.box_bits)),
                 hi = std::uint32_t(draw.natural(config.box_bits));
            if (draw.below(8) == 0) hi = lo;
            node.lo[3 * i + k] = std::min(lo, hi);
            node.hi[3 * i + k] = std::max(lo, hi);
        }
    }
    return node;
}

/// Half of the rays aim at a corner, an edge, a face or the inside of a child; some start there. If the chip
/// shades, they are camera rays, bounces and shadow rays.
inline BoxCase random_box_case(Draw& draw, const Config& config) {
    BoxCase c;
    const int frac = config.origin_frac();
    const auto kind = RayKind(config.shading ? draw.below(3) : 0);
    c.is_long = kind == RayKind::shadow;
    c.req.ray = std::uint32_t(draw.natural(config.ray_bits()));
    const Vec3i near = draw.vector(config.coord_bits);
    for (std::size_t k = 0; k < 3; ++k)
        c.req.o[k] = near[k] * (1 << frac) + (kind == RayKind::bounce ? int(draw.natural(frac)) : 0);
    static_cast<Node&>(c.req.node) = random_node(draw, config, near);
    const int bits = c.is_long ? config.ray_dir_bits() : config.dir_bits;
    Vec3i d = draw.vector(bits);
    if (draw.percent(70)) {
        int children = 0;
        while (children < config.node_width && c.req.node.kind[std::size_t(children)] != 0) ++children;
        const oracle::Box box = child_box(c.req.node, std::size_t(draw.below(children)), frac);
        const std::int64_t most = (std::int64_t(1) << (bits - 1)) - 1;
        const int factor = 1 << draw.below(4);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t lo = box.lo[k].convert_to<std::int64_t>(),
                               hi = box.hi[k].convert_to<std::int64_t>();
            const std::int64_t places[] = {lo, hi, lo + (hi - lo) / 2, lo - 1, hi + 1};
            const std::int64_t target = places[draw.below(5)], grid = 1 << (config.origin_width() - 1);
            // A short direction has no room for the fraction.
            const std::int64_t parts = c.is_long ? 1 : 1 << frac;
            if (kind != RayKind::shadow && draw.below(8) == 0 && target >= -grid && target < grid)
                c.req.o[k] = std::int32_t(target);
            d[k] = std::int32_t(std::clamp((target - c.req.o[k]) * factor / parts, -most - 1, most));
        }
    }
    if (draw.below(3) == 0) d[std::size_t(draw.below(3))] = 0;
    set_direction(c, d, config);
    return c;
}

/// Returns t_near of the child at `offset`, if the answer contains it.
inline std::optional<std::uint32_t> reported(const NodeAnswer& rsp, std::uint32_t offset) {
    for (std::size_t i = 0; i < rsp.inner + rsp.leaves; ++i)
        if (rsp.offset[i] == offset) return rsp.t_near[i];
    return std::nullopt;
}

/// Requires that no child that the ray meets is missing and that t_near is never beyond the entry. Any other
/// child must be within the permitted tolerance.
inline void judge_boxes(const BoxCase& c, const NodeAnswer& rsp, const Config& config) {
    const Node& node = c.req.node;
    const auto o = oracle::point(c.req.o), d = oracle::point(c.d);
    const int frac = config.origin_frac(), bits = c.is_long ? config.ray_dir_bits() : config.dir_bits;
    const oracle::Rational unit = oracle::power_of_two(bits - 1 + config.t_frac_bits - frac);
    const oracle::Int beyond = (oracle::Int(1) << config.t_bits()) - 1;
    const oracle::Licence licence{config.recip_bits, beyond, (oracle::Int(1) << frac) - 1};
    std::uint32_t inner = 0, triangles = 0, found = 0;
    for (std::size_t i = 0; i < std::size_t(config.node_width); ++i) inner += node.kind[i] == 1;
    for (std::size_t i = 0; i < std::size_t(config.node_width) && node.kind[i] != 0; ++i) {
        // Layout of a block: one line for each inner child, then the triangles, two to a line.
        const auto offset = node.kind[i] == 1 ? std::uint32_t(2 * i) : 2 * inner + triangles;
        triangles += node.kind[i] - 1;
        const oracle::Box box = child_box(node, i, frac);
        const auto exact = oracle::interval(o, d, box, unit);
        const auto grown = oracle::interval(o, d, box, unit, &licence);
        const auto said = reported(rsp, offset);
        CAPTURE(i, offset, c.d[0], c.d[1], c.d[2]);
        if (exact) REQUIRE(said);
        if (said) REQUIRE(grown);
        if (exact) REQUIRE(*said <= std::min(oracle::floor(exact->enter), beyond));
        if (said) REQUIRE(*said >= grown->enter);
        found += said.has_value();
    }
    REQUIRE(found == rsp.inner + rsp.leaves);
}

/// Requires counts and order: inner children first, each part sorted by (t_near, offset), then zeros. Ray and
/// base are unchanged.
inline void judge_order(const BoxCase& c, const NodeAnswer& rsp, const Config& config) {
    REQUIRE(rsp.ray == c.req.ray);
    REQUIRE(rsp.base == c.req.node.base);
    std::uint32_t inner = 0;
    for (int i = 0; i < config.node_width; ++i) inner += c.req.node.kind[std::size_t(i)] == 1;
    for (std::size_t i = 0; i < std::size_t(config.node_width); ++i) {
        CAPTURE(i);
        if (i >= rsp.inner + rsp.leaves) {
            REQUIRE((rsp.t_near[i] == 0 && rsp.offset[i] == 0 && rsp.count[i] == 0));
            continue;
        }
        REQUIRE((rsp.count[i] == 0) == (i < rsp.inner));
        REQUIRE((rsp.offset[i] < 2 * inner) == (i < rsp.inner));
        if (i > 0 && i != rsp.inner)
            REQUIRE(std::pair(rsp.t_near[i - 1], rsp.offset[i - 1]) <
                    std::pair(rsp.t_near[i], rsp.offset[i]));
    }
}

/// Requires that every reported leaf has its number of triangles.
inline void judge_counts(const BoxCase& c, const NodeAnswer& rsp, const Config& config) {
    std::uint32_t at = 0;
    for (std::size_t i = 0; i < std::size_t(config.node_width); ++i) at += 2 * (c.req.node.kind[i] == 1);
    for (std::size_t i = 0; i < std::size_t(config.node_width); ++i) {
        if (c.req.node.kind[i] < 2) continue;
        for (std::size_t p = rsp.inner; p < rsp.inner + rsp.leaves; ++p)
            if (rsp.offset[p] == at) REQUIRE(rsp.count[p] == c.req.node.kind[i] - 1);
        at += c.req.node.kind[i] - 1;
    }
}

inline void judge(const BoxCase& c, const NodeAnswer& rsp, const Config& config) {
    judge_boxes(c, rsp, config);
    judge_order(c, rsp, config);
    judge_counts(c, rsp, config);
}

}   // namespace rayclock::test
