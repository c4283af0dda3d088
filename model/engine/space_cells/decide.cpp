// Crossings of planes, and the exits that a ray meets.
#include "model/engine/space_cells/decide.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "model/engine/space_cells/axis.hpp"

namespace rayclock {

void WideExits::place(std::uint32_t base, const std::array<std::uint32_t, max_width>& kind,
                      std::size_t width) {
    exits.base = base;
    const auto place = [&](std::size_t at, std::uint32_t offset, std::uint32_t count) {
        exit[exits.children] = std::uint8_t(at);
        exits.offset[exits.children] = std::uint8_t(offset);
        exits.count[exits.children] = std::uint8_t(count);
        ++exits.children;
    };
    for (std::size_t i = 0; i < width; ++i)
        if (kind[i] == 1) place(i, 2u * exits.children, 0);
    exits.inner_mask = std::uint8_t((1u << exits.children) - 1);
    std::uint32_t half_lines = 2u * exits.children;
    for (std::size_t i = 0; i < width; ++i) {
        if (kind[i] < 2) continue;
        place(i, half_lines, kind[i] - 1);
        half_lines += kind[i] - 1;
    }
    exits.children_mask = std::uint8_t((1u << exits.children) - 1);
}

namespace {

/// Returns 2^x as a double, without a call: every plane of every node needs it.
double power_of_two(int x) { return std::bit_cast<double>(std::uint64_t(1023 + x) << 52); }

}   // namespace

PlaneSides plane_sides(const BoxRay& ray, std::uint32_t axis, std::int32_t at, const Config& c) {
    const std::uint32_t beyond = (1u << c.t_bits()) - 1;
    PlaneSides sides;
    sides.near_to = beyond;
    if (axis >= no_axis) return sides;
    // The last lattice point not beyond the origin. `between` is 1 if the origin lies between two points.
    const int frac = c.origin_frac();
    const std::int32_t o = ray.o[axis] >> frac, between = (ray.o[axis] & ((1 << frac) - 1)) != 0;
    const bool neg = ray.neg[axis] != 0;
    const std::int32_t w_hi = neg ? o + between - at : at - o, w_lo = w_hi - between;
    if (ray.len[axis] == 0) {
        sides.near = w_lo >= 0;
        sides.far = w_hi <= 0;
        return sides;
    }
    sides.turned = neg;
    sides.near = w_hi > 0;
    if (!sides.near) return sides;
    const int shift = c.t_frac_bits + c.ray_dir_bits() - int(ray.len[axis]) - c.recip_bits;
    // A whole number below 2^53 times a power of two: exact. It is clamped before the conversion to an
    // integer rounds it down.
    const double way = double(ray.recip[axis]) * w_lo * power_of_two(shift);
    sides.far_from = std::uint32_t(std::min(way, double(beyond)));
    const std::uint64_t step = std::uint64_t(between) << (shift + c.recip_bits),
                        to = sides.far_from + (sides.far_from >> (c.recip_bits - 1)) + 2 + step;
    sides.near_to = std::uint32_t(std::min<std::uint64_t>(to, beyond));
    return sides;
}

namespace {

/// A part of a ray, which planes shorten.
struct Span {
    std::uint32_t from = 0, to;
    bool met = true;
    /// Shortens it to a plane's upper side, or its lower one.
    void cut(const PlaneSides& s, bool upper) {
        if (upper == s.turned) {
            met = met && s.near;
            to = std::min(to, s.near_to);
        } else {
            met = met && s.far;
            from = std::max(from, s.far_from);
        }
    }
};

}   // namespace

std::uint32_t exits_met(const BoxRay& ray, const WideExits& treelet, const AllSides& sides, const Config& c,
                        std::uint32_t* t_near) {
    Span box{0, (1u << c.t_bits()) - 1};
    for (std::uint32_t k = 0; k < 3 && !treelet.open; ++k) {
        box.cut(plane_sides(ray, k, treelet.lo[k], c), true);
        box.cut(plane_sides(ray, k, treelet.hi[k], c), false);
    }
    const auto width = std::uint32_t(c.node_width);
    std::uint32_t hits = 0;
    for (std::uint32_t child = 0; child < treelet.exits.children; ++child) {
        Span span = box;
        std::uint32_t plane = 0;
        for (std::uint32_t half = width / 2; half > 0; half /= 2) {
            const bool upper = treelet.exit[child] & half;
            span.cut(sides[plane], upper);
            plane = 2 * plane + 1 + upper;
        }
        t_near[child] = span.from;
        hits |= std::uint32_t(span.met && span.from <= span.to) << child;
    }
    return hits;
}

}   // namespace rayclock
