// Origins and directions of secondary rays in exact arithmetic.
#include "model/unit/tri/origin.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

#include "model/unit/tri/edges.hpp"

namespace rayclock {

namespace {

Vec3l normal(const PrimData& t) { return cross(minus(t.b, t.a), minus(t.c, t.a)); }
int sign(Int128 value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Returns tri_test's decision for s in units of 2^-one_bits.
std::optional<OriginHit> hit_of(const Vec3l& s, const Vec3l& d, const PrimData& triangle, int one_bits) {
    Edges<Int128> e;
    bool flip = false;
    if (!meet(s, d, triangle, one_bits, true, e, flip)) return std::nullopt;
    return OriginHit{e.num, e.det >> one_bits};
}

std::uint64_t magnitude(std::int64_t value) { return std::uint64_t(value < 0 ? -value : value); }
std::int64_t round_down(std::int64_t value, int drop) { return value >> drop; }
std::int64_t round_up(std::int64_t value, int drop) { return -(-value >> drop); }

}   // namespace

Weights inner_weights(std::uint32_t u, std::uint32_t v, int bary_bits, int frac_bits) {
    assert(frac_bits >= least_origin_bits && frac_bits <= bary_bits &&
           "a point inside exists, and u and v have its bits");
    const std::uint32_t one = 1u << frac_bits;
    const int drop = bary_bits - frac_bits;
    const auto rounded = [&](std::uint32_t x) { return drop == 0 ? x : ((x >> (drop - 1)) + 1) >> 1; };
    Weights w{std::max(rounded(u), 1u), std::max(rounded(v), 1u)};
    // The excess is at most 2, and then the larger weight has at least half of the whole.
    const std::uint32_t excess = w.u + w.v < one ? 0 : w.u + w.v - (one - 1);
    (w.u > w.v ? w.u : w.v) -= excess;
    return w;
}

SurfacePoint surface_point(const PrimData& triangle, const Weights& weights, int frac_bits) {
    const Vec3l e1 = minus(triangle.b, triangle.a), e2 = minus(triangle.c, triangle.a);
    SurfacePoint point{{}, frac_bits};
    for (std::size_t k = 0; k < 3; ++k)
        point.at[k] = std::int64_t(triangle.a[k]) * (std::int64_t(1) << frac_bits) + weights.u * e1[k] +
                      weights.v * e2[k];
    return point;
}

int side_of_direction(const PrimData& triangle, const Vec3i& d) {
    return sign(dot<Int128>(normal(triangle), {d[0], d[1], d[2]}));
}
int side_of_point(const PrimData& triangle, const Vec3i& point) {
    return sign(dot<Int128>(normal(triangle), minus(point, triangle.a)));
}

Vec3i leaving_direction(const Vec3l& way, const PrimData& triangle, int facing, int dir_bits) {
    const std::uint64_t most = std::max({magnitude(way[0]), magnitude(way[1]), magnitude(way[2])});
    const std::uint64_t largest = (std::uint64_t(1) << (dir_bits - 1)) - 1;
    int shift = std::max(int(std::bit_width(most)) - (dir_bits - 1), 0);
    if (most > largest << shift) ++shift;   // rounding up would exceed the largest value by one
    const Vec3l n = normal(triangle);
    Vec3i d{};
    for (std::size_t k = 0; k < 3; ++k)
        d[k] = std::int32_t((n[k] > 0) == (facing > 0) ? round_up(way[k], shift) : round_down(way[k], shift));
    return d;
}

std::optional<OriginHit> bounce_test(const SurfacePoint& o, const Vec3i& d, const PrimData& triangle) {
    Vec3l s{};
    for (std::size_t k = 0; k < 3; ++k) s[k] = o.at[k] - triangle.a[k] * (std::int64_t(1) << o.frac_bits);
    return hit_of(s, {d[0], d[1], d[2]}, triangle, o.frac_bits);
}

bool nearer(const OriginHit& one, const OriginHit& other) {
    return Product(one.num, other.det) < Product(other.num, one.det);
}

Vec3l shadow_direction(const Vec3i& light, const SurfacePoint& o) {
    Vec3l d{};
    for (std::size_t k = 0; k < 3; ++k) d[k] = o.at[k] - light[k] * (std::int64_t(1) << o.frac_bits);
    return d;
}

bool shadow_test(const Vec3i& light, const Vec3l& d, int frac_bits, const PrimData& triangle) {
    const auto hit = hit_of(minus(light, triangle.a), d, triangle, 0);
    return hit && hit->num << frac_bits < hit->det;
}

BoxOrigin box_origin(const SurfacePoint& o, const Vec3i& d) {
    BoxOrigin box;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto below = std::int32_t(round_down(o.at[k], o.frac_bits)),
                   above = std::int32_t(round_up(o.at[k], o.frac_bits));
        box.near[k] = d[k] < 0 ? below : above;
        box.far[k] = d[k] < 0 ? above : below;
    }
    return box;
}

}   // namespace rayclock
