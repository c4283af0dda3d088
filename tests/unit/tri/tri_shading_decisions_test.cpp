// tri of a shading chip: decisions about single rays, computed by other means.
#include "model/unit/tri/origin.hpp"
#include "sim/judge/reference/round.hpp"
#include "tests/support/cases/any_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

TEST_CASE("a bounce and a shadow ray are decided as docs/proofs/origins.md has it", "[any]") {
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

TEMPLATE_TEST_CASE("the sphere test distinguishes inside, rim and the sphere's own rays", "[tri][any]",
                   Model<TriUnit>, Rtl<TriUnit>) {
    const Config config = any_format("default");
    const int one = 1 << config.origin_bits, full = 1 << (config.dir_bits - 1);
    const auto ray = [&](RayKind kind, Vec3i o, Vec3i d, std::uint32_t self = 1, std::uint32_t inside = 0) {
        TriReq r;
        r.kind = kind;
        r.o = o;
        r.d = d;
        r.self = self;
        r.is_inside = inside;
        r.triangle = {{0, 0, 0}, {100 * 100, 0, 1}, {}, 9, PrimKind::sphere};   // radius 100
        return r;
    };
    const auto camera = [&](Vec3i o, Vec3i d) {
        return ray(RayKind::camera, scaled(o, config.origin_bits), d);
    };
    const auto bounce = [&](Vec3i o, Vec3i d, std::uint32_t self = 1, std::uint32_t inside = 0) {
        return ray(RayKind::bounce, o, d, self, inside);
    };
    const auto away = [&](Vec3i o, Vec3i d, std::uint32_t self = 1, std::uint32_t inside = 0) {
        return ray(RayKind::away, o, d, self, inside);
    };
    const auto shadow = [&](Vec3i light, Vec3i end, std::uint32_t self = 1, std::uint32_t inside = 0) {
        const Vec3i o = scaled(light, config.origin_bits);
        return ray(RayKind::shadow, o, {end[0] - o[0], end[1] - o[1], end[2] - o[2]}, self, inside);
    };
    struct Case {
        TriReq req;
        // `t` in lattice steps. `opaque` is `closer` for an opaque sphere.
        std::uint32_t closer, t, back, opaque;
    };
    const int rim = 100 * one;
    const Case cases[] = {
        {camera({-300, 0, 0}, {full - 1, 0, 0}), 1, 200, 0, 1},     // from outside
        {camera({-300, 100, 0}, {full - 1, 0, 0}), 1, 300, 0, 1},   // touches
        {camera({-300, 101, 0}, {full - 1, 0, 0}), 0, 0, 0, 0},
        {camera({300, 0, 0}, {full - 1, 0, 0}), 0, 0, 0, 0},   // behind
        {camera({50, 0, 0}, {full - 1, 0, 0}), 1, 50, 1, 0},   // from inside
        {camera({50, 0, 0}, {-full, 0, 0}), 1, 150, 1, 0},
        {camera({0, 0, 0}, {0, 0, 0}), 0, 0, 0, 0},            // no direction
        {camera({100, 0, 0}, {full - 1, 0, 0}), 0, 0, 0, 0},   // on it, leaving
        {camera({100, 0, 0}, {0, -full, 0}), 0, 0, 0, 0},      // along it
        {camera({100, 0, 0}, {-full, 0, 0}), 1, 200, 1, 0},    // on it, entering
        // Another primitive's ray, the least distance off its rim: at most 1 step.
        {bounce({rim + 1, 0, 0}, {-full, 0, 0}), 1, 1, 0, 1},
        // Its own ray, outside.
        {bounce({rim + 1, 0, 0}, {-full, 0, 0}, 9), 0, 0, 0, 0},
        // Its own ray, outside, and rounded inside.
        {bounce({rim - 1, 0, 0}, {-full, 0, 0}, 9), 0, 0, 0, 0},
        // Its own ray, inside, and rounded outside.
        {bounce({rim + 1, 0, 0}, {-full, 0, 0}, 9, 1), 1, 201, 1, 0},
        {bounce({rim - 1, 0, 0}, {-full, 0, 0}, 9, 1), 1, 200, 1, 0},
        {bounce({rim + 1, 0, 0}, {full - 1, 0, 0}, 9, 1), 0, 0, 0, 0},
        {away({-300 * one, 0, 0}, {full - 1, 0, 0}), 1, 0, 0, 1},
        {away({-300 * one, 0, 0}, {-full, 0, 0}), 0, 0, 0, 0},
        {away({rim - 1, 0, 0}, {full - 1, 0, 0}), 1, 0, 0, 0},
        {away({rim - 1, 0, 0}, {full - 1, 0, 0}, 9), 0, 0, 0, 0},
        {away({rim + 1, 0, 0}, {-full, 0, 0}, 9, 1), 1, 0, 0, 0},
        {shadow({-300, 0, 0}, scaled({300, 0, 0}, config.origin_bits)), 1, 0, 0, 1},
        {shadow({-300, 100, 0}, scaled({300, 100, 0}, config.origin_bits)), 1, 0, 0, 1},   // touches
        {shadow({-300, 101, 0}, scaled({300, 101, 0}, config.origin_bits)), 0, 0, 0, 0},
        {shadow({-300, 0, 0}, {-rim, 0, 0}), 0, 0, 0, 0},             // up to it
        {shadow({-300, 0, 0}, {-rim + 1, 0, 0}), 1, 0, 0, 0},         // into it
        {shadow({-300, 0, 0}, {rim, 0, 0}), 1, 0, 0, 0},              // to its other side
        {shadow({-300, 0, 0}, {-rim + 1, 0, 0}, 9, 0), 0, 0, 0, 0},   // to its own point
        {shadow({-300, 0, 0}, {-rim - 1, 0, 0}, 9, 1), 1, 0, 0, 0},   // to its own point, seen from inside
        {shadow({0, 0, 0}, {rim + 1, 0, 0}, 9, 1), 0, 0, 0, 0},       // the same, and the light is inside
        {shadow({0, 0, 0}, {rim + 1, 0, 0}), 1, 0, 0, 1},             // out of it
        {shadow({0, 0, 0}, {rim, 0, 0}), 0, 0, 0, 0},
        {shadow({100, 0, 0}, {rim + 1, 0, 0}), 0, 0, 0, 0},                             // a light on it: away
        {shadow({100, 0, 0}, {-rim - 1, 0, 0}), 1, 0, 0, 1},                            // through it
        {shadow({100, 0, 0}, {-rim, 0, 0}), 0, 0, 0, 0},                                // to a point of it
        {shadow({-300, 0, 0}, scaled({-300, 0, 0}, config.origin_bits)), 0, 0, 0, 0},   // zero length
    };
    std::vector<TriReq> requests;
    for (const Case& c : cases) requests.push_back(c.req);
    for (const Case& c : cases) {
        requests.push_back(c.req);
        requests.back().triangle.b[2] = 0;
    }
    TestType dut{config};
    const auto rsps = answers(dut, config, requests);
    for (std::size_t i = std::size(cases); i < rsps.size(); ++i) {
        CAPTURE(i - std::size(cases));
        REQUIRE(rsps[i].closer == cases[i - std::size(cases)].opaque);
        REQUIRE(rsps[i].back == 0);
        judge_any(requests[i], rsps[i], config);
    }
    for (std::size_t i = 0; i < std::size(cases); ++i) {
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

namespace {

/// A ray between two small integer points, and a sphere of integer radius at an approximate third. Nothing
/// touches or starts on anything, so doubles decide like integers.
struct WholeMeeting {
    Vec3i from{}, to{}, centre{};
    int radius = 1;
    bool is_glass = false;

    explicit WholeMeeting(Draw& draw) : radius(draw.between(1, 5)), is_glass(draw.coin()) {
        for (Vec3i* point : {&from, &to, &centre})
            for (std::int32_t& x : *point) x = draw.between(-5, 5);
    }
    /// Returns the squared distance from the centre minus the squared radius.
    int outside(const Vec3i& point) const {
        int sum = -radius * radius;
        for (std::size_t k = 0; k < 3; ++k) sum += (point[k] - centre[k]) * (point[k] - centre[k]);
        return sum;
    }
    bool is_clear_cut() const {
        int along = 0, square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            along += (from[k] - centre[k]) * (to[k] - from[k]);
            square += (to[k] - from[k]) * (to[k] - from[k]);
        }
        return square != 0 && outside(from) != 0 && outside(to) != 0 &&
               along * along != square * outside(from);
    }
    TriReq request(RayKind kind, const Config& c) const {
        TriReq r;
        r.kind = kind;
        r.self = 1;
        r.triangle = {centre, {radius * radius, 0, is_glass}, {}, 9, PrimKind::sphere};
        r.o = scaled(from, c.origin_bits);
        const int length = kind == RayKind::shadow ? 1 << c.origin_bits : 1000;
        for (std::size_t k = 0; k < 3; ++k) r.d[k] = (to[k] - from[k]) * length;
        return r;
    }
    /// Returns the reference's hit before `reach` on the way from `start` to `end`.
    RefClosest reference(const Vec3i& start, const Vec3i& end, double reach) const {
        const auto place = [](const Vec3i& p) { return glm::dvec3(p[0], p[1], p[2]); };
        RefClosest closest{.depth = reach, .primitive = no_primitive};
        test_sphere({place(centre), double(radius), 9, is_glass},
                    {place(start), glm::normalize(place(end) - place(start))}, closest);
        return closest;
    }
};

}   // namespace

TEST_CASE("a sphere is met by the rays by which the reference meets it", "[any]") {
    const Config config = any_format("default");
    Draw draw{29};
    int met[4][2][2] = {};   // [kind][glass][met]
    for (int i = 0; i < 40000; ++i) {
        const WholeMeeting m(draw);
        if (!m.is_clear_cut()) continue;
        for (const RayKind kind : {RayKind::camera, RayKind::bounce, RayKind::away, RayKind::shadow}) {
            const TriRsp rsp = tri(m.request(kind, config), config);
            CAPTURE(i, int(kind), m.is_glass, m.outside(m.from), m.outside(m.to));
            // A shadow ray runs from the light to the point, but the reference searches from the point.
            const bool is_shadow = kind == RayKind::shadow;
            const RefClosest right =
                is_shadow ? m.reference(m.to, m.from,
                                        glm::length(glm::dvec3(m.to[0] - m.from[0], m.to[1] - m.from[1],
                                                               m.to[2] - m.from[2])))
                          : m.reference(m.from, m.to, HUGE_VAL);
            REQUIRE((rsp.closer != 0) == (right.primitive == 9));
            if (rsp.closer && !ends_at_any(kind)) REQUIRE((rsp.back != 0) == (m.outside(m.from) < 0));
            ++met[int(kind)][m.is_glass][rsp.closer];
        }
    }
    for (const auto& of_kind : met)
        for (const auto& of_look : of_kind) CHECK((of_look[0] > 2000 && of_look[1] > 2000));
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
        // The same one wins in either order.
        REQUIRE(tri(r, config).closer + tri(other, config).closer == 1);
        turned += tri(r, config).closer != 0;
    }
    REQUIRE(turned > 50);
}
