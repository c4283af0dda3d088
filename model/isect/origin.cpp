#include "model/isect/origin.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

#include "model/isect/vectors.hpp"

namespace rayclock {

namespace {

Wide dot(const Vec3l& a, const Vec3l& b) { return Wide(a[0]) * b[0] + Wide(a[1]) * b[1] + Wide(a[2]) * b[2]; }
Vec3l normal(const PrimData& t) { return cross(minus(t.b, t.a), minus(t.c, t.a)); }
int sign(Wide value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// The edge function is positive, a zero being decided as in tri_test.
bool inside(Wide edge, const Vec3l& gradient, bool flip) {
    const Wide decides = edge != 0          ? edge
                         : gradient[0] != 0 ? gradient[0]
                         : gradient[1] != 0 ? gradient[1]
                                            : gradient[2];
    return flip ? decides < 0 : decides > 0;
}

/// tri_test's formulas for s in units of 2^-one_bits.
std::optional<OriginHit> meet(const Vec3l& s, const Vec3l& d, const PrimData& triangle, int one_bits) {
    const Vec3l e1 = minus(triangle.b, triangle.a), e2 = minus(triangle.c, triangle.a);
    const Vec3l p1 = cross(d, e1), p2 = cross(d, e2);
    const Wide det = dot(p2, e1);
    if (det == 0) return std::nullopt;
    const bool flip = det < 0;
    const Wide u = dot(p2, s), v = -dot(p1, s), w = det * (Wide(1) << one_bits) - u - v;
    const Vec3l grad_v{-p1[0], -p1[1], -p1[2]}, grad_w{p1[0] - p2[0], p1[1] - p2[1], p1[2] - p2[2]};
    if (!inside(u, p2, flip) || !inside(v, grad_v, flip) || !inside(w, grad_w, flip)) return std::nullopt;
    const Wide num = dot(cross(e1, e2), s);
    const OriginHit hit{flip ? -num : num, flip ? -det : det};
    if (hit.num <= 0) return std::nullopt;
    return hit;
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
    // At most 2 too much, and then the larger of the two has at least half of the whole.
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
    return sign(dot(normal(triangle), {d[0], d[1], d[2]}));
}
int side_of_point(const PrimData& triangle, const Vec3i& point) {
    return sign(dot(normal(triangle), minus(point, triangle.a)));
}

Vec3i leaving_direction(const Vec3l& way, const PrimData& triangle, int facing, int dir_bits) {
    const std::uint64_t most = std::max({magnitude(way[0]), magnitude(way[1]), magnitude(way[2])});
    const std::uint64_t largest = (std::uint64_t(1) << (dir_bits - 1)) - 1;
    int shift = std::max(int(std::bit_width(most)) - (dir_bits - 1), 0);
    if (most > largest << shift) ++shift;   // rounded up it would be one more than the largest
    const Vec3l n = normal(triangle);
    Vec3i d{};
    for (std::size_t k = 0; k < 3; ++k)
        d[k] = std::int32_t((n[k] > 0) == (facing > 0) ? round_up(way[k], shift) : round_down(way[k], shift));
    return d;
}

std::optional<OriginHit> bounce_test(const SurfacePoint& o, const Vec3i& d, const PrimData& triangle) {
    Vec3l s{};
    for (std::size_t k = 0; k < 3; ++k) s[k] = o.at[k] - triangle.a[k] * (std::int64_t(1) << o.frac_bits);
    return meet(s, {d[0], d[1], d[2]}, triangle, o.frac_bits);
}

bool nearer(const OriginHit& one, const OriginHit& other) {
    // num det' may pass 128 bits, so it is made in two parts of 64; det has at most 64.
    struct Product {
        Wide high;
        std::uint64_t low;
    };
    const auto product = [](Wide num, Wide det) {
        __extension__ using Unsigned = unsigned __int128;
        assert(num >= 0 && det > 0 && det >> 64 == 0 &&
               "a hit's parts are positive, det fits 2N + M + 2 bits");
        const Unsigned low = Unsigned(std::uint64_t(num)) * std::uint64_t(det);
        return Product{(num >> 64) * det + Wide(low >> 64), std::uint64_t(low)};
    };
    const Product mine = product(one.num, other.det), theirs = product(other.num, one.det);
    return mine.high != theirs.high ? mine.high < theirs.high : mine.low < theirs.low;
}

Vec3l shadow_direction(const Vec3i& light, const SurfacePoint& o) {
    Vec3l d{};
    for (std::size_t k = 0; k < 3; ++k) d[k] = o.at[k] - light[k] * (std::int64_t(1) << o.frac_bits);
    return d;
}

bool shadow_test(const Vec3i& light, const Vec3l& d, int frac_bits, const PrimData& triangle) {
    const auto hit = meet(minus(light, triangle.a), d, triangle, 0);
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
