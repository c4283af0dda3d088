// origin: points of a surface, and rays from and to them. All decisions are exact.
#include <catch2/catch.hpp>

#include "model/unit/tri/origin.hpp"
#include "model/unit/tri/tri.hpp"
#include "tests/support/oracle/fractions.hpp"
#include "tests/support/cases/draw.hpp"

using namespace rayclock;
using namespace rayclock::test;
using oracle::Int;
using oracle::Rational;

namespace {

const int lattices[] = {12, 14, 16, 18, 20};

PrimData random_triangle(Draw& draw, int bits) {
    PrimData t;
    t.a = draw.vector(bits);
    t.b = draw.coin() ? draw.vector(bits) : draw.near(t.a, 1 << draw.below(bits - 1), bits);
    t.c = draw.coin() ? draw.vector(bits) : draw.near(t.b, 1 << draw.below(bits - 1), bits);
    return t;
}
SurfacePoint random_point(Draw& draw, const PrimData& t, int frac_bits) {
    const int one = 1 << frac_bits;
    const std::uint32_t u = std::uint32_t(draw.below(one + 1)),
                        v = std::uint32_t(draw.below(one + 1 - int(u)));
    return surface_point(t, inner_weights(u, v, frac_bits, frac_bits), frac_bits);
}
/// Draws a triangle near the ray's path from p, so that it is often met. Sometimes the path meets an edge or
/// a corner, or the triangle contains p.
PrimData ahead(Draw& draw, const SurfacePoint& p, const Vec3l& way, int bits) {
    PrimData t = random_triangle(draw, bits);
    if (draw.percent(30)) return t;
    Vec3i at{};
    const int part = draw.below(9), step = p.frac_bits + 3;
    for (std::size_t k = 0; k < 3; ++k) at[k] = std::int32_t((p.at[k] * 8 + way[k] * part) >> step);
    const int reach = 1 << draw.below(bits - 1);
    t.a = draw.near(at, reach, bits);
    t.b = draw.near(at, reach, bits);
    t.c = draw.percent(30) ? draw.near(at, 1, bits) : draw.near(at, reach, bits);
    return t;
}
oracle::Point scaled(const Vec3i& p, int bits) {
    return {Int(p[0]) << bits, Int(p[1]) << bits, Int(p[2]) << bits};
}
oracle::Point between(const Vec3i& a, const Vec3i& b) {
    return {Int(b[0]) - a[0], Int(b[1]) - a[1], Int(b[2]) - a[2]};
}
Int dot(const oracle::Point& a, const oracle::Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
oracle::Point cross(const oracle::Point& a, const oracle::Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
int sign(const Int& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
Int wide(Int128 x) {
    Int r = Int(std::int64_t(x >> 64));
    r <<= 64;
    return r + Int(std::uint64_t(x));
}

/// Returns how much weight (in units of 2^-B) moves from one corner to another between `before` and `after`.
Rational moved(const std::array<Rational, 3>& before, const std::array<Rational, 3>& after) {
    Rational sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += abs(after[k] - before[k]);
    return sum / 2;
}

}   // namespace

TEST_CASE("weights of a surface point are inside, and near those of the hit", "[origin]") {
    const int bary = 6;
    for (int bits = least_origin_bits; bits <= bary; ++bits)
        for (std::uint32_t u = 0; u <= 1u << bary; ++u)
            for (std::uint32_t v = 0; u + v <= 1u << bary; ++v) {
                const Weights w = inner_weights(u, v, bary, bits);
                CAPTURE(bits, u, v, w.u, w.v);
                REQUIRE(w.u >= 1);
                REQUIRE(w.v >= 1);
                REQUIRE(w.u + w.v < 1u << bits);
                // The hit's true u and v are the given ones, or up to one unit of 2^-bary more, as far as
                // their sum allows.
                const Rational unit = oracle::power_of_two(bits - bary), one = oracle::power_of_two(bits);
                const std::array<Rational, 3> after{Rational(w.u), Rational(w.v), Rational(one - w.u - w.v)};
                for (const int more : {0, 1, 2, 3}) {
                    const Rational tu = u + Rational(more & 1, 1), tv = v + Rational(more >> 1, 1);
                    const std::array<Rational, 3> before{Rational(tu * unit), Rational(tv * unit),
                                                         Rational(one - (tu + tv) * unit)};
                    if (before[2] >= 0) REQUIRE(moved(before, after) <= 2);
                    // Away from the border only rounding remains.
                    if (bits < bary && more == 0 && w.u > 1 && w.v > 1 && w.u + w.v + 1 < 1u << bits) {
                        REQUIRE(abs(after[0] - before[0]) <= Rational(1, 2));
                        REQUIRE(abs(after[1] - before[1]) <= Rational(1, 2));
                    }
                }
            }
}

TEST_CASE("a surface point lies exactly in its triangle, strictly inside, near the hit", "[origin]") {
    const int bits = GENERATE(from_range(std::begin(lattices), std::end(lattices))),
              frac_bits = GENERATE(2, 4, 8, 13, 16);
    Config config;
    config.coord_bits = bits;
    config.dir_bits = bits + 2;
    Draw draw{unsigned(bits * 100 + frac_bits)};
    int hits = 0;
    for (int i = 0; i < 4000 && hits < 400; ++i) {
        const PrimData t = random_triangle(draw, bits);
        Vec3i o = draw.vector(bits), d;
        const Vec3i& aim = draw.coin() ? t.b : t.c;
        for (std::size_t k = 0; k < 3; ++k) d[k] = draw.coin() ? aim[k] - o[k] : (aim[k] + t.a[k]) / 2 - o[k];
        TriRsp rsp;
        tri_test(o, d, t, {}, config, rsp);
        if (rsp.closer == 0) continue;
        ++hits;
        const SurfacePoint p =
            surface_point(t, inner_weights(rsp.u, rsp.v, config.bary_bits, frac_bits), frac_bits);
        // Seen from p, the triangle's corners span three triangles. Their areas have the sign and the sum of
        // the whole area.
        const oracle::Point e1 = between(t.a, t.b), e2 = between(t.a, t.c), n = cross(e1, e2);
        oracle::Point from_a = scaled(t.a, frac_bits);
        for (std::size_t k = 0; k < 3; ++k) from_a[k] = p.at[k] - from_a[k];
        REQUIRE(dot(n, from_a) == 0);
        const Rational area = Rational(dot(n, n));
        const Rational one = oracle::power_of_two(frac_bits);
        const Rational u = Rational(dot(cross(from_a, e2), n)) / area,
                       v = Rational(dot(cross(e1, from_a), n)) / area;
        REQUIRE(u > 0);
        REQUIRE(v > 0);
        REQUIRE(u + v < one);
        const auto truth = oracle::crossing(oracle::point(o), oracle::point(d), oracle::point(t.a),
                                            oracle::point(t.b), oracle::point(t.c));
        REQUIRE(truth);
        const std::array<Rational, 3> before{Rational(truth->u * one), Rational(truth->v * one),
                                             Rational((1 - truth->u - truth->v) * one)};
        REQUIRE(moved(before, {u, v, Rational(one - u - v)}) <= 2);
    }
    REQUIRE(hits > 50);
}

TEST_CASE("rays from a surface point are decided exactly", "[origin]") {
    const int bits = GENERATE(from_range(std::begin(lattices), std::end(lattices))),
              frac_bits = GENERATE(2, 8, 16);
    Draw draw{unsigned(bits * 100 + frac_bits)};
    int hits = 0;
    std::optional<OriginHit> last;
    Rational last_t;
    for (int i = 0; i < 3000; ++i) {
        const PrimData own = random_triangle(draw, bits);
        SurfacePoint p = random_point(draw, own, frac_bits);
        Vec3i d = draw.vector(bits + 2);
        Vec3l way{d[0], d[1], d[2]};
        PrimData t = ahead(
            draw, p, {way[0] << frac_bits >> 3, way[1] << frac_bits >> 3, way[2] << frac_bits >> 3}, bits);
        if (draw.percent(20)) {   // through a corner or an edge's middle, from a lattice point
            const Vec3i o = draw.vector(bits);
            p.at = {std::int64_t(o[0]) << frac_bits, std::int64_t(o[1]) << frac_bits,
                    std::int64_t(o[2]) << frac_bits};
            for (std::size_t k = 0; k < 3; ++k)
                d[k] = draw.coin() ? t.a[k] + t.b[k] - 2 * o[k] : 2 * (t.c[k] - o[k]);
        }
        const auto hit = bounce_test(p, d, t);
        const oracle::Point o{Int(p.at[0]), Int(p.at[1]), Int(p.at[2])};
        const auto truth = oracle::crossing(o, oracle::point(d), scaled(t.a, frac_bits),
                                            scaled(t.b, frac_bits), scaled(t.c, frac_bits));
        CAPTURE(bits, frac_bits, i);
        REQUIRE(hit.has_value() == truth.has_value());
        REQUIRE(!bounce_test(p, d, own).has_value() ==
                !oracle::crossing(o, oracle::point(d), scaled(own.a, frac_bits), scaled(own.b, frac_bits),
                                  scaled(own.c, frac_bits)));
        if (!hit) continue;
        ++hits;
        REQUIRE(Rational(wide(hit->num), wide(hit->det)) == truth->t);
        if (last) {
            REQUIRE(nearer(*hit, *last) == (truth->t < last_t));
            REQUIRE(nearer(*last, *hit) == (last_t < truth->t));
            REQUIRE(!nearer(*hit, *hit));
        }
        last = hit;
        last_t = truth->t;
    }
    REQUIRE(hits > 100);
}

TEST_CASE("a blocker between a light and a surface point is decided exactly", "[origin]") {
    const int bits = GENERATE(from_range(std::begin(lattices), std::end(lattices))),
              frac_bits = GENERATE(2, 8, 16);
    Draw draw{unsigned(bits * 100 + frac_bits)};
    int blocked = 0, crossed = 0;
    for (int i = 0; i < 3000; ++i) {
        const PrimData own = random_triangle(draw, bits);
        const SurfacePoint p = random_point(draw, own, frac_bits);
        const Vec3i light = draw.percent(10) ? own.a : draw.vector(bits);
        const Vec3l d = shadow_direction(light, p);
        PrimData t = ahead(draw, p, {-d[0], -d[1], -d[2]}, bits);
        if (draw.percent(10)) t.a = light;
        const oracle::Point way{Int(d[0]), Int(d[1]), Int(d[2])};
        const auto truth = oracle::crossing(oracle::point(light), way, oracle::point(t.a), oracle::point(t.b),
                                            oracle::point(t.c));
        const bool between = truth && truth->t < oracle::power_of_two(-frac_bits);
        CAPTURE(bits, frac_bits, i);
        REQUIRE(shadow_test(light, d, frac_bits, t) == between);
        REQUIRE(!shadow_test(light, d, frac_bits, own));
        blocked += between;
        crossed += truth.has_value();
    }
    REQUIRE(blocked > 100);
    REQUIRE(crossed > blocked + 20);
}

TEST_CASE("every value of a secondary ray's tests fits the widths stated", "[origin]") {
    const int bits = GENERATE(from_range(std::begin(lattices), std::end(lattices))),
              frac_bits = GENERATE(2, 16);
    const int dir_bits = bits + 2;
    const auto extreme = [](int which, int n) {
        const std::int32_t most = (1 << (n - 1)) - 1;
        return Vec3i{which & 1 ? most : -most - 1, which & 2 ? most : -most - 1,
                     which & 4 ? most : -most - 1};
    };
    const auto fits = [](const Int& x, int n) { return x >= -(Int(1) << (n - 1)) && x < Int(1) << (n - 1); };
    int fullest = 0;
    for (int which = 0; which < 1 << 15; which += 1 + which % 3) {   // corners of o, d, a, b, c
        const Vec3i o = extreme(which, bits), a = extreme(which >> 3, bits), b = extreme(which >> 6, bits),
                    c = extreme(which >> 9, bits);
        const auto check = [&](const oracle::Point& origin, const oracle::Point& d, const RayWidths& w,
                               int one_bits) {
            const oracle::Point e1 = between(a, b), e2 = between(a, c);
            oracle::Point s = scaled(a, one_bits);
            for (std::size_t k = 0; k < 3; ++k) s[k] = origin[k] - s[k];
            const Int det = dot(d, cross(e2, e1)), u = dot(d, cross(e2, s)), v = dot(d, cross(s, e1)),
                      num = dot(cross(e1, e2), s);
            const Int rest = (det << one_bits) - u - v;
            REQUIRE((fits(det, w.det) && fits(u, w.edge) && fits(v, w.edge) && fits(rest, w.edge) &&
                     fits(num, w.num)));
            for (std::size_t k = 0; k < 3; ++k)
                REQUIRE((fits(origin[k], w.point) && fits(d[k], w.direction) && fits(s[k], w.offset)));
            fullest += !fits(u, w.edge - 1) || !fits(rest, w.edge - 1);
        };
        check(scaled(o, frac_bits), oracle::point(extreme(which >> 12, dir_bits)),
              bounce_widths(bits, dir_bits, frac_bits), frac_bits);
        const Vec3i light = extreme(which >> 12, bits);
        oracle::Point way = scaled(light, frac_bits);
        for (std::size_t k = 0; k < 3; ++k) way[k] = (Int(o[k]) << frac_bits) - way[k];
        check(oracle::point(light), way, shadow_widths(bits, frac_bits), 0);
    }
    REQUIRE(fullest > 0);   // no bit is unused
}

TEST_CASE("a direction that is cut leaves on the side meant", "[origin]") {
    const int bits = GENERATE(from_range(std::begin(lattices), std::end(lattices)));
    Draw draw{unsigned(bits)};
    int cut = 0;
    for (int i = 0; i < 20000; ++i) {
        const PrimData t = random_triangle(draw, bits);
        Vec3l way{draw.number(bits + 17), draw.number(bits + 17), draw.number(bits + 17)};
        if (draw.coin())   // nearly along the surface
            for (std::size_t k = 0; k < 3; ++k)
                way[k] = (t.b[k] - t.a[k]) * std::int64_t(17) + (t.c[k] - t.a[k]) * std::int64_t(5) +
                         draw.between(-2, 2);
        const oracle::Point n = cross(between(t.a, t.b), between(t.a, t.c)),
                            w{Int(way[0]), Int(way[1]), Int(way[2])};
        const int facing = sign(dot(n, w));
        if (facing == 0) continue;
        const int dir_bits = 4 + draw.below(bits);
        const Vec3i d = leaving_direction(way, t, facing, dir_bits);
        CAPTURE(bits, i, dir_bits);
        REQUIRE(sign(dot(n, oracle::point(d))) == facing);
        REQUIRE(side_of_direction(t, d) == facing);
        // A power of two makes it the path up to less than one unit. The largest component has all bits but
        // one, or is whole.
        const std::int64_t most = (std::int64_t(1) << (dir_bits - 1)) - 1;
        bool found = false;
        for (int shift = 0; shift < bits + 18 && !found; ++shift) {
            bool good = true, large = shift == 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int64_t unit = std::int64_t(1) << shift;
                good = good && std::abs(d[k] * unit - way[k]) < unit && std::abs(d[k]) <= most;
                large = large || std::abs(d[k]) >= most / 2;
            }
            found = good && large;
            cut += found && shift > 0;
        }
        REQUIRE(found);
        const Vec3i point = draw.near(t.a, 1 << draw.below(bits - 1), bits);
        REQUIRE(side_of_point(t, point) == sign(dot(n, between(t.a, point))));
    }
    REQUIRE(cut > 1000);
}

TEST_CASE("the box test's origins lie outward of a surface point", "[origin]") {
    // Exhaustive on a small lattice: every origin with two fraction bits, every slab, every sign of
    // direction.
    const int frac_bits = 2, one = 1 << frac_bits;
    for (int at = -4 * one; at <= 4 * one; ++at)
        for (const int d : {-3, -1, 0, 1, 5})
            for (int lo = -5; lo <= 5; ++lo)
                for (int hi = lo; hi <= 5; ++hi) {
                    const BoxOrigin from = box_origin({{at, -at, 0}, frac_bits}, {d, -d, 0});
                    const oracle::Box slab{
                        {Int(lo), Int(-9), Int(-9)}, {Int(hi), Int(9), Int(9)}, {Int(1), Int(1), Int(1)}};
                    const oracle::Box scaled_slab{{Int(lo * one), Int(-99), Int(-99)},
                                                  {Int(hi * one), Int(99), Int(99)},
                                                  {Int(1), Int(1), Int(1)}};
                    const auto truth =
                        oracle::interval({Int(at), Int(0), Int(0)}, {Int(d), Int(0), Int(0)}, scaled_slab, 1);
                    CAPTURE(at, d, lo, hi);
                    if (d != 0)
                        // The mirrored ray.
                        REQUIRE((from.near[0] == -from.near[1] && from.far[0] == -from.far[1]));
                    if (!truth) continue;
                    if (d == 0) {   // any point that neither excludes
                        REQUIRE(lo <= from.near[0]);
                        REQUIRE(hi >= from.far[0]);
                        continue;
                    }
                    const Rational near =
                        d > 0 ? Rational(lo - from.near[0], d) : Rational(from.near[0] - hi, -d);
                    const Rational far =
                        d > 0 ? Rational(hi - from.far[0], d) : Rational(from.far[0] - lo, -d);
                    REQUIRE(near * one <= truth->enter);
                    REQUIRE(far * one >= *truth->leave);
                    REQUIRE(near * one > Rational(d > 0 ? lo * one - at : at - hi * one, std::abs(d)) -
                                             Rational(one, std::abs(d)));
                }
}
