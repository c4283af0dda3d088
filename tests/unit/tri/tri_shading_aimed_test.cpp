// tri of a shading chip, with operands that random ones do not reach. They are a sphere touched at the end of
// a shadow ray, the ends of t, u and v, discriminants that are nearly a square, and a sphere as far as the
// previous hit.
#include <cmath>

#include "model/base/rng.hpp"
#include "model/unit/tri/vectors.hpp"
#include "tests/support/cases/any_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

void set_sphere(PrimData& p, const Vec3i& centre, std::uint64_t square, int bits) {
    const auto field = [bits](std::uint64_t part) {
        return std::int32_t(std::int64_t(part << (64 - bits)) >> (64 - bits));
    };
    p.kind = PrimKind::sphere;
    p.prim = 7;
    p.a = centre;
    p.b = {field(square), field(square >> bits), 1};
}

std::int64_t root(std::int64_t x) {
    auto r = std::int64_t(std::sqrt(double(x)));
    while (r * r > x) --r;
    while ((r + 1) * (r + 1) <= x) ++r;
    return r;
}

template <class Dut> std::vector<TriRsp> judged(const std::vector<TriReq>& requests, const Config& c) {
    Dut dut{c};
    const std::vector<TriRsp> rsps = answers(dut, c, requests);
    for (std::size_t i = 0; i < rsps.size(); ++i) {
        CAPTURE(i);
        judge_any(requests[i], rsps[i], c);
    }
    return rsps;
}

}   // namespace

TEMPLATE_TEST_CASE("a sphere that is touched where a shadow ray ends is not in its way", "[tri][any][aimed]",
                   Model<TriUnit>, Rtl<TriUnit>) {
    const Config c = any_format("default");
    std::vector<TriReq> requests;
    std::vector<bool> blocked;
    for (const std::size_t i : {0u, 1u, 2u})
        for (const std::size_t j : {(i + 1) % 3, (i + 2) % 3})
            for (int way = 1; way <= 9; ++way)
                for (int radius = 1; radius <= 9; ++radius)
                    // The end lies this many steps of 2^-B behind the touched point.
                    for (const int more : {-1, 0, 1}) {
                        TriReq r;
                        r.kind = RayKind::shadow;
                        set_sphere(r.triangle, {3, -2, 5}, std::uint64_t(radius) * std::uint64_t(radius),
                                   c.coord_bits);
                        Vec3i light = r.triangle.a;
                        light[i] += way, light[j] += radius;
                        for (std::size_t k = 0; k < 3; ++k) r.o[k] = light[k] * (1 << c.origin_bits);
                        r.d[i] = -way * (1 << c.origin_bits) - more;
                        requests.push_back(r);
                        blocked.push_back(more > 0);
                    }
    const std::vector<TriRsp> rsps = judged<TestType>(requests, c);
    for (std::size_t k = 0; k < rsps.size(); ++k) {
        CAPTURE(k);
        REQUIRE((rsps[k].closer != 0) == blocked[k]);
    }
}

TEMPLATE_TEST_CASE("t ends where its bits do", "[tri][any][aimed]", Model<TriUnit>, Rtl<TriUnit>) {
    const Config c = any_format("default");
    const std::uint64_t most = (std::uint64_t(1) << c.t_bits()) - 1;
    std::vector<TriReq> requests;
    std::vector<std::uint64_t> expected;
    // At distance h along a direction of length d, t = 2^(M-1+F) h / d; it is 2^T where d is h / 2^(N+3-M).
    for (const int h : {1, 2, 3, 4, 1000, 4096, 65535, 65536, 100001, 131070})
        for (const int part : {1, 2, 3, 4, 5, 8, 16, 1 << 16})
            for (const int more : {-1, 0, 1}) {
                const int d = h / part + more;
                if (d < 1) continue;
                TriReq r;
                r.kind = RayKind::camera;
                r.triangle.a = {-100000, -100000, 0}, r.triangle.b = {100000, -100000, 0},
                r.triangle.c = {0, 100000, 0};
                r.triangle.prim = 7;
                r.o[2] = h * (1 << c.origin_bits);
                r.d[2] = -d;
                requests.push_back(r);
                const std::uint64_t t =
                    (std::uint64_t(h) << (c.dir_bits - 1 + c.t_frac_bits)) + std::uint64_t(d - 1);
                expected.push_back(std::min(t / std::uint64_t(d), most));
            }
    const std::vector<TriRsp> rsps = judged<TestType>(requests, c);
    int ends = 0, falls_short = 0;
    for (std::size_t k = 0; k < rsps.size(); ++k) {
        CAPTURE(k);
        REQUIRE(rsps[k].closer == 1);
        REQUIRE(rsps[k].t == expected[k]);
        ends += expected[k] == most;
        falls_short += expected[k] < most && expected[k] > most / 2;
    }
    CHECK(ends > 20);
    CHECK(falls_short > 5);
}

TEST_CASE("a discriminant next to a square is not treated as a square", "[tri][any][aimed][long]") {
    const Config c = any_format("wide");
    // From inside along x: the discriminant is d^2 q, q = 4^B R^2 - y^2 - z^2. The test searches q = 4 k^2 +
    // 1, 2 or 3 with k of 28 bits. Then the root of the kept bits is exactly k, and only the dropped bits
    // show that it must be rounded up. k is also such that t, which has fewer bits, is whole, and one more if
    // the root is rounded up.
    const std::int64_t square = std::int64_t(524000) * 524000, all = square << (2 * c.origin_bits);
    const std::int64_t step = std::int64_t(1) << std::max(0, c.origin_bits - c.t_frac_bits - 2);
    std::vector<TriReq> requests;
    for (std::int64_t k = (root(all / 4) - 1) / step * step; requests.size() < 20; k -= step) {
        REQUIRE(k >> 27 == 1);
        const std::int64_t rest = all - 4 * k * k, y = root(rest - 1), z = root(rest - 1 - y * y),
                           left = rest - y * y - z * z;
        if (left > 3) continue;
        TriReq r;
        r.kind = RayKind::bounce;
        set_sphere(r.triangle, {0, 0, 0}, std::uint64_t(square), c.coord_bits);
        r.o = {0, std::int32_t(y), std::int32_t(z)};
        r.d = {1 << (c.dir_bits - 2), 0, 0};
        requests.push_back(r);
    }
    const std::vector<TriRsp> model = judged<Model<TriUnit>>(requests, c),
                              rtl = judged<Rtl<TriUnit>>(requests, c);
    for (std::size_t i = 0; i < model.size(); ++i) {
        CAPTURE(i, model[i].t, rtl[i].t);
        REQUIRE(model[i].closer == 1);
        REQUIRE(model[i].t == rtl[i].t);
    }
}

TEMPLATE_TEST_CASE("a plane's u and v end where their bits do", "[tri][any][aimed]", Model<TriUnit>,
                   Rtl<TriUnit>) {
    const Config c = any_format("default");
    const int whole = c.uv_bits() - 1 - c.bary_bits;   // bits of u and v above the point, excluding the sign
    const std::int32_t end = 1 << whole, most = (1 << (c.coord_bits - 1)) - 1;
    std::vector<TriReq> requests;
    std::vector<std::array<std::int64_t, 2>> expected;
    // u and v are whole steps, odd and even, without a remainder.
    const std::int32_t fine = 1 << c.bary_bits;
    for (const std::int32_t side : {1, 2, 3, 5, fine})
        for (const std::int32_t more : {-1, 0, 1})
            for (const std::int32_t sign : {-1, 1})
                for (const std::size_t axis : {0u, 1u}) {
                    TriReq r;
                    r.kind = RayKind::camera;
                    r.triangle.kind = PrimKind::plane;
                    r.triangle.prim = 7;
                    r.triangle.b = {side, 0, 0}, r.triangle.c = {0, side, 0};
                    Vec3i at{1, 1, 100};
                    at[axis] = side == fine ? 4 * sign + more : sign * end * side + more;
                    if (std::abs(at[axis]) > most) continue;
                    for (std::size_t k = 0; k < 3; ++k) r.o[k] = at[k] * (1 << c.origin_bits);
                    r.d[2] = -(1 << (c.dir_bits - 2));
                    requests.push_back(r);
                    const std::int64_t one = std::int64_t(1) << c.bary_bits,
                                       last = (std::int64_t(end) << c.bary_bits) - 1;
                    std::array<std::int64_t, 2> uv{};
                    for (std::size_t k = 0; k < 2; ++k) {
                        const std::int64_t scaled = at[k] * one, floor = scaled / side - (scaled % side < 0);
                        uv[k] = std::clamp(floor, -last - 1, last);
                    }
                    expected.push_back(uv);
                }
    REQUIRE(requests.size() > 20);
    const std::vector<TriRsp> rsps = judged<TestType>(requests, c);
    const auto number = [&](std::uint32_t field) {
        return std::int64_t(std::uint64_t(field) << (64 - c.uv_bits())) >> (64 - c.uv_bits());
    };
    for (std::size_t k = 0; k < rsps.size(); ++k) {
        CAPTURE(k, rsps[k].u, rsps[k].v);
        REQUIRE(rsps[k].closer == 1);
        REQUIRE(number(rsps[k].u) == expected[k][0]);
        REQUIRE(number(rsps[k].v) == expected[k][1]);
    }
}

TEMPLATE_TEST_CASE("a sphere as near as what was hit before goes before higher numbers and its own",
                   "[tri][any][aimed]", Model<TriUnit>, Rtl<TriUnit>) {
    const Config c = any_format("default");
    std::vector<TriReq> requests;
    for (const std::int64_t further : {-1, 0, 1})
        for (const std::uint32_t prim : {6u, 7u, 8u}) {
            TriReq r;
            r.kind = RayKind::camera;
            set_sphere(r.triangle, {0, 0, 0}, 100, c.coord_bits);
            r.o[2] = 30 * (1 << c.origin_bits);
            r.d[2] = -(1 << (c.dir_bits - 2));
            // Its near side is at 20 steps, twice as many in units of a direction.
            const int units = c.dir_bits - 1 + c.t_frac_bits;
            r.best.found = 1, r.best.prim = prim;
            r.best.det = std::uint64_t(1) << units;
            r.best.num = std::uint64_t((std::int64_t(40) << c.t_frac_bits) + further);
            requests.push_back(r);
        }
    const std::vector<TriRsp> rsps = judged<TestType>(requests, c);
    for (std::size_t k = 0; k < rsps.size(); ++k) {
        CAPTURE(k);
        REQUIRE((rsps[k].closer != 0) == (k > 5 || (k > 2 && k % 3 > 0)));
    }
}

TEMPLATE_TEST_CASE("a ray that passes an edge by the least there is is on its side", "[tri][any][aimed]",
                   Model<TriUnit>, Rtl<TriUnit>) {
    const Config c = any_format("default");
    const std::int32_t one = 1 << c.origin_bits;
    Rng rng(20261122);
    const auto point = [&](int most) {
        return Vec3i{rng.below(2 * most + 1) - most, rng.below(2 * most + 1) - most,
                     rng.below(2 * most + 1) - most};
    };
    std::vector<TriReq> requests;
    for (int i = 0; i < 2000000 && requests.size() < 600; ++i) {
        TriReq r;
        r.kind = RayKind::bounce;
        r.triangle.a = point(1), r.triangle.b = point(1), r.triangle.c = point(1);
        r.triangle.prim = 7;
        r.o = point(one), r.d = point(1);
        Vec3l s, e1, e2;
        for (std::size_t k = 0; k < 3; ++k) {
            s[k] = r.o[k] - std::int64_t(r.triangle.a[k]) * one;
            e1[k] = r.triangle.b[k] - r.triangle.a[k], e2[k] = r.triangle.c[k] - r.triangle.a[k];
        }
        const Vec3l d{r.d[0], r.d[1], r.d[2]}, p1 = cross(d, e1), p2 = cross(d, e2);
        const auto dot = [](const Vec3l& a, const Vec3l& b) {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        };
        const std::int64_t det = dot(p2, e1), u = dot(p2, s), v = -dot(p1, s), w = det * one - u - v;
        if (det == 0 || (std::abs(u) != 1 && std::abs(v) != 1 && std::abs(w) != 1)) continue;
        requests.push_back(r);
    }
    REQUIRE(requests.size() > 300);
    int hits = 0;
    for (const TriRsp& rsp : judged<TestType>(requests, c)) hits += rsp.closer != 0;
    CHECK(hits > 20);
}
