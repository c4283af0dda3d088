// tri of a chip that shades: its decisions about single rays, worked out beside it.
#include "model/isect/origin.hpp"
#include "tests/support/cases/any_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

TEST_CASE("a bounce and a shadow ray are decided as docs/origins.md has it", "[any]") {
    const Config config = any_format(GENERATE("default", "small", "wide"), "");
    Draw draw{unsigned(config.coord_bits)};
    int hits = 0, blocked = 0;
    for (int i = 0; i < 20000; ++i) {
        const TriReq r = random_any_req(draw, config);
        TriReq alone = r;
        alone.best = {};
        const TriRsp rsp = tri(alone, config);
        if (leaves(r)) {
            const auto hit = bounce_test({{r.o[0], r.o[1], r.o[2]}, config.origin_bits}, r.d, r.triangle);
            REQUIRE(hit.has_value() == (rsp.closer != 0));
            if (hit && !ends_at_any(r.kind))
                REQUIRE((rsp.num == hit->num && rsp.det == hit->det << config.origin_bits &&
                         rsp.back == (side_of_direction(r.triangle, r.d) > 0)));
            hits += hit.has_value();
        } else if (is_shadow(r)) {
            const Vec3i light{r.o[0] >> config.origin_bits, r.o[1] >> config.origin_bits,
                              r.o[2] >> config.origin_bits};
            REQUIRE(shadow_test(light, {r.d[0], r.d[1], r.d[2]}, config.origin_bits, r.triangle) ==
                    (rsp.closer != 0));
            blocked += rsp.closer != 0;
        } else if (rsp.closer) {
            TriRsp plain;
            tri_test(
                {r.o[0] >> config.origin_bits, r.o[1] >> config.origin_bits, r.o[2] >> config.origin_bits},
                r.d, r.triangle, {}, config, plain);
            REQUIRE((rsp.num == plain.num && rsp.det == plain.det && rsp.t == plain.t));
        }
    }
    REQUIRE(hits > 500);
    REQUIRE(blocked > 200);
}

TEMPLATE_TEST_CASE("a sphere is told from its inside, its rim and its own rays", "[tri][any]", Model<TriUnit>,
                   Rtl<TriUnit>) {
    const Config config = any_format("default");
    const int one = 1 << config.origin_bits, full = 1 << (config.dir_bits - 1);
    const auto ray = [&](std::uint32_t kind, Vec3i o, Vec3i d, std::uint32_t self = 1,
                         std::uint32_t inside = 0) {
        TriReq r;
        r.kind = kind;
        r.o = o;
        r.d = d;
        r.self = self;
        r.inside = inside;
        r.triangle = {{0, 0, 0}, {100 * 100, 0, 0}, {}, 9, 2};   // radius 100
        return r;
    };
    const auto camera = [&](Vec3i o, Vec3i d) { return ray(0, scaled(o, config.origin_bits), d); };
    const auto bounce = [&](Vec3i o, Vec3i d, std::uint32_t self = 1, std::uint32_t inside = 0) {
        return ray(1, o, d, self, inside);
    };
    const auto away = [&](Vec3i o, Vec3i d, std::uint32_t self = 1, std::uint32_t inside = 0) {
        return ray(3, o, d, self, inside);
    };
    const auto shadow = [&](Vec3i light, Vec3i end, std::uint32_t self = 1, std::uint32_t inside = 0) {
        const Vec3i o = scaled(light, config.origin_bits);
        return ray(2, o, {end[0] - o[0], end[1] - o[1], end[2] - o[2]}, self, inside);
    };
    struct Case {
        TriReq req;
        std::uint32_t closer, t, back;   // t in lattice steps
    };
    const int rim = 100 * one;
    const Case cases[] = {
        {camera({-300, 0, 0}, {full - 1, 0, 0}), 1, 200, 0},     // from outside
        {camera({-300, 100, 0}, {full - 1, 0, 0}), 1, 300, 0},   // a touch
        {camera({-300, 101, 0}, {full - 1, 0, 0}), 0, 0, 0},
        {camera({300, 0, 0}, {full - 1, 0, 0}), 0, 0, 0},   // behind
        {camera({50, 0, 0}, {full - 1, 0, 0}), 1, 50, 1},   // from inside
        {camera({50, 0, 0}, {-full, 0, 0}), 1, 150, 1},
        {camera({0, 0, 0}, {0, 0, 0}), 0, 0, 0},             // goes nowhere
        {camera({100, 0, 0}, {full - 1, 0, 0}), 0, 0, 0},    // on it, leaving
        {camera({100, 0, 0}, {0, -full, 0}), 0, 0, 0},       // along it
        {camera({100, 0, 0}, {-full, 0, 0}), 1, 200, 1},     // on it, entering
        {bounce({rim + 1, 0, 0}, {-full, 0, 0}), 1, 1, 0},   // another's ray, a hair off its rim: 1 step at
                                                             // most
        {bounce({rim + 1, 0, 0}, {-full, 0, 0}, 9), 0, 0, 0},        // its own, outside
        {bounce({rim - 1, 0, 0}, {-full, 0, 0}, 9), 0, 0, 0},        // its own, outside, and rounded inside
        {bounce({rim + 1, 0, 0}, {-full, 0, 0}, 9, 1), 1, 201, 1},   // its own, inside, and rounded outside
        {bounce({rim - 1, 0, 0}, {-full, 0, 0}, 9, 1), 1, 200, 1},
        {bounce({rim + 1, 0, 0}, {full - 1, 0, 0}, 9, 1), 0, 0, 0},
        {away({-300 * one, 0, 0}, {full - 1, 0, 0}), 1, 0, 0},
        {away({-300 * one, 0, 0}, {-full, 0, 0}), 0, 0, 0},
        {away({rim - 1, 0, 0}, {full - 1, 0, 0}), 1, 0, 0},
        {away({rim - 1, 0, 0}, {full - 1, 0, 0}, 9), 0, 0, 0},
        {away({rim + 1, 0, 0}, {-full, 0, 0}, 9, 1), 1, 0, 0},
        {shadow({-300, 0, 0}, scaled({300, 0, 0}, config.origin_bits)), 1, 0, 0},
        {shadow({-300, 100, 0}, scaled({300, 100, 0}, config.origin_bits)), 1, 0, 0},   // a touch
        {shadow({-300, 101, 0}, scaled({300, 101, 0}, config.origin_bits)), 0, 0, 0},
        {shadow({-300, 0, 0}, {-rim, 0, 0}), 0, 0, 0},             // up to it
        {shadow({-300, 0, 0}, {-rim + 1, 0, 0}), 1, 0, 0},         // into it
        {shadow({-300, 0, 0}, {rim, 0, 0}), 1, 0, 0},              // to its other side
        {shadow({-300, 0, 0}, {-rim + 1, 0, 0}, 9, 0), 0, 0, 0},   // to its own point
        {shadow({-300, 0, 0}, {-rim - 1, 0, 0}, 9, 1), 1, 0, 0},   // to its own point, seen from inside
        {shadow({0, 0, 0}, {rim + 1, 0, 0}, 9, 1), 0, 0, 0},       // the same, the light inside as well
        {shadow({0, 0, 0}, {rim + 1, 0, 0}), 1, 0, 0},             // out of it
        {shadow({0, 0, 0}, {rim, 0, 0}), 0, 0, 0},
        {shadow({100, 0, 0}, {rim + 1, 0, 0}), 0, 0, 0},                             // a light on it: away
        {shadow({100, 0, 0}, {-rim - 1, 0, 0}), 1, 0, 0},                            // through
        {shadow({100, 0, 0}, {-rim, 0, 0}), 0, 0, 0},                                // to a point of it
        {shadow({-300, 0, 0}, scaled({-300, 0, 0}, config.origin_bits)), 0, 0, 0},   // no way at all
    };
    std::vector<TriReq> requests;
    for (const Case& c : cases) requests.push_back(c.req);
    TestType dut{config};
    const auto rsps = answers(dut, config, requests);
    for (std::size_t i = 0; i < rsps.size(); ++i) {
        CAPTURE(i, cases[i].req.kind, rsps[i].t);
        REQUIRE(rsps[i].closer == cases[i].closer);
        REQUIRE(rsps[i].back == cases[i].back);
        if (cases[i].t)
            REQUIRE(std::uint32_t((rsps[i].t + (1u << config.t_frac_bits) - 1) >> config.t_frac_bits) -
                        cases[i].t <=
                    1);
        judge_any(requests[i], rsps[i], config);
    }
}

TEST_CASE("spheres, planes and triangles are ranked by one measure", "[any]") {
    const Config config = any_format("default");
    Draw draw{17};
    int turned = 0;
    for (int i = 0; i < 4000; ++i) {
        TriReq r = random_any_req(draw, config);
        if (ends_at_any(r.kind)) continue;
        r.best = {};
        TriReq other = r;
        other.triangle = random_prim(
            draw, config,
            {r.o[0] >> config.origin_bits, r.o[1] >> config.origin_bits, r.o[2] >> config.origin_bits});
        if (other.triangle.prim == r.triangle.prim) continue;
        const TriRsp one = tri(r, config), two = tri(other, config);
        if (!one.closer || !two.closer) continue;
        r.best = {1, two.num, two.det, two.prim};
        other.best = {1, one.num, one.det, one.prim};
        REQUIRE(tri(r, config).closer + tri(other, config).closer == 1);   // whoever comes first, the same
                                                                           // one wins
        turned += tri(r, config).closer != 0;
    }
    REQUIRE(turned > 50);
}
