// tri: tests rays against triangles; all decisions are exact.
#include "tests/support/cases/tri_cases.hpp"

namespace rayclock::test::tri_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

template <class Dut> void against_oracle(const char* name, unsigned seed, const Pace& pace, int count) {
    const Config config = format(name);
    INFO(name << ", seed " << seed);
    Draw draw{seed};
    Dut dut{config, Frame{}, int(seed)};
    int hits = 0;
    stream(
        dut, config, pace, draw, count, [&](Draw& from) { return random_tri_req(from, config); },
        [&](const TriReq& req, const TriRsp& rsp) {
            judge(req, rsp, config);
            hits += rsp.closer != 0;
        });
    REQUIRE(hits > count / 20);
}

/// Returns a corner of the lattice: bit k of `which` selects the largest or smallest coordinate on axis k.
Vec3i extreme(int which, int bits) {
    const std::int32_t most = (1 << (bits - 1)) - 1;
    return {which & 1 ? most : -most - 1, which & 2 ? most : -most - 1, which & 4 ? most : -most - 1};
}

}   // namespace

TEMPLATE_TEST_CASE("tri decides and measures exactly", "[tri]", Model<TriUnit>, Rtl<TriUnit>) {
    const auto name = GENERATE("default", "small", "narrow", "wide");
    for (unsigned seed = 1; seed <= 4; ++seed) against_oracle<TestType>(name, seed, paces[seed - 1], 1500);
}

TEMPLATE_TEST_CASE("tri decides and measures exactly, many draws", "[tri][slow]", Model<TriUnit>,
                   Rtl<TriUnit>) {
    const auto name = GENERATE("default", "small", "narrow", "wide");
    for (unsigned seed = 101; seed <= 110; ++seed)
        against_oracle<TestType>(name, seed, paces[seed % 4], 4000);
}

TEMPLATE_TEST_CASE("tri is exact at the corners of the lattice", "[tri]", Model<TriUnit>, Rtl<TriUnit>) {
    const Config config = format(GENERATE("default", "wide", "fast:default"));
    std::vector<TriReq> requests;
    for (int a = 0; a < 8; ++a)
        for (int b = 0; b < 8; ++b)
            for (int c = 0; c < 8; ++c)
                for (int o = (a + b + c) % 5; o < 8; o += 5)
                    for (int d = (a + 2 * b + o) % 3; d < 8; d += 3) {
                        if (a == b || b == c || c == a) continue;
                        TriReq req;
                        req.o = extreme(o, config.coord_bits);
                        req.d = extreme(d, config.dir_bits);
                        req.triangle = {extreme(a, config.coord_bits), extreme(b, config.coord_bits),
                                        extreme(c, config.coord_bits), 7};
                        requests.push_back(req);
                    }
    TestType dut{config};
    const auto rsps = answers(dut, config, requests);
    for (std::size_t i = 0; i < rsps.size(); ++i) judge(requests[i], rsps[i], config);
}

TEST_CASE("model and RTL of the sheared tri are equal at the corners of the lattice",
          "[tri][lockstep][sheared][long]") {
    const Config config = format(GENERATE("sheared:default", "sheared:wide"));
    std::vector<TriReq> requests;
    for (int i = 0; i < 1 << 15; i += 3) {   // corners a, b, c, origin and direction
        TriReq req;
        req.o = extreme(i >> 9 & 7, config.coord_bits);
        req.d = extreme(i >> 12 & 7, config.dir_bits);
        req.shear = shear_of(req.d, config);
        req.triangle = {extreme(i & 7, config.coord_bits), extreme(i >> 3 & 7, config.coord_bits),
                        extreme(i >> 6 & 7, config.coord_bits), 7};
        requests.push_back(req);
    }
    Rtl<TriUnit> dut{config};
    const auto rsps = answers(dut, config, requests);
    int hits = 0;
    for (std::size_t i = 0; i < rsps.size(); ++i) {
        CAPTURE(i);
        REQUIRE(same(rsps[i], tri(requests[i], config), config));
        hits += rsps[i].closer != 0;
    }
    REQUIRE(hits > 50);
}

TEMPLATE_TEST_CASE("tri keeps the nearer hit, and of equals the lower number", "[tri]", Model<TriUnit>,
                   Rtl<TriUnit>) {
    const Config config = format("default");
    TestType dut{config};
    TriReq req;
    req.o = {10, 20, -1000};
    req.d = {0, 0, 3000};
    req.triangle = {{-500, -400, 70}, {600, -300, 150}, {-20, 900, 333}, 40};
    const TriRsp first = answers(dut, config, {req})[0];
    REQUIRE(first.closer == 1);
    std::vector<TriReq> again(5, req);
    for (auto& r : again) r.best = {1, first.num, first.det, 40};
    again[0].triangle.prim = 39;
    again[1].triangle.prim = 41;
    again[2].triangle = {req.triangle.c, req.triangle.b, req.triangle.a, 39};   // the same plane from behind
    again[3].triangle.a[2] = again[3].triangle.b[2] = again[3].triangle.c[2] = 400;
    again[4].triangle.a[2] = again[4].triangle.b[2] = again[4].triangle.c[2] = 60;
    const auto rsps = answers(dut, config, again);
    const std::uint32_t closer[] = {1, 0, 1, 0, 1};
    for (std::size_t i = 0; i < 5; ++i) {
        CAPTURE(i);
        REQUIRE(rsps[i].closer == closer[i]);
        judge(again[i], rsps[i], config);
    }
}

TEMPLATE_TEST_CASE("tri reports no hit for triangles edge-on, behind the origin, or at it", "[tri]",
                   Model<TriUnit>, Rtl<TriUnit>) {
    const Config config = format("default");
    TestType dut{config};
    TriReq ahead;
    ahead.o = {0, 0, 0};
    ahead.d = {0, 0, 1};
    ahead.triangle = {{-100, -100, 1}, {100, -100, 1}, {0, 200, 1}, 5};
    TriReq behind = ahead, at = ahead, edge_on = ahead, flat = ahead, point = ahead, still = ahead;
    behind.d = {0, 0, -1};
    at.o = {0, 0, 1};
    edge_on.triangle = {{0, -100, 50}, {0, 100, 50}, {0, 0, 200}, 5};
    flat.triangle = {{-10, 0, 5}, {0, 0, 5}, {10, 0, 5}, 5};
    point.triangle = {{0, 0, 5}, {0, 0, 5}, {0, 0, 5}, 5};
    still.d = {0, 0, 0};
    const auto rsps = answers(dut, config, {ahead, behind, at, edge_on, flat, point, still});
    REQUIRE(rsps[0].closer == 1);
    for (std::size_t i = 1; i < rsps.size(); ++i) {
        CAPTURE(i);
        REQUIRE(rsps[i].closer == 0);
    }
}

TEMPLATE_TEST_CASE("tri answers after exactly its latency", "[tri][long]", Model<TriUnit>, Rtl<TriUnit>) {
    const Config config =
        format(GENERATE("default", "narrow", "wide", "sheared:default", "sheared:wide", "fast:default",
                        "fast:narrow", "fast:sheared:default", "every2:default", "every4:fast:default"));
    TestType dut{config};
    check_latency(dut, config, [&](Draw& draw) { return random_tri_req(draw, config); });
}

TEMPLATE_TEST_CASE("tri accepts a triangle in every cycle, or every few", "[tri][long]", Model<TriUnit>,
                   Rtl<TriUnit>) {
    const Config config = format(GENERATE("default", "wide", "sheared:default", "sheared:wide",
                                          "fast:default", "every2:default", "every4:fast:default"));
    TestType dut{config};
    check_throughput(dut, config, [&](Draw& draw) { return random_tri_req(draw, config); });
}

TEST_CASE("model and RTL of tri make the same moves in every cycle", "[tri][lockstep]") {
    const Config config = format(GENERATE("default", "small", "narrow", "wide"));
    for (const Pace& pace : paces)
        for (unsigned seed = 11; seed <= 13; ++seed)
            check_lockstep<TriUnit>(config, {}, pace, seed, 1500,
                                    [&](Draw& draw) { return random_tri_req(draw, config); });
}

TEST_CASE("model and RTL of a fast tri make the same moves in every cycle", "[tri][lockstep][fast][long]") {
    const Config config =
        format(GENERATE("fast:default", "fast:small", "fast:narrow", "fast:wide", "fast:sheared:default"));
    for (const Pace& pace : paces)
        for (unsigned seed = 11; seed <= 13; ++seed)
            check_lockstep<TriUnit>(config, {}, pace, seed, 1500,
                                    [&](Draw& draw) { return random_tri_req(draw, config); });
}

TEST_CASE("model and RTL of a tri that shares multipliers make the same moves in every cycle",
          "[tri][lockstep][interval]") {
    const Config config = format(GENERATE("every2:default", "every4:fast:default"));
    for (const Pace& pace : paces)
        check_lockstep<TriUnit>(config, {}, pace, 17, 1500 * config.tri_interval,
                                [&](Draw& draw) { return random_tri_req(draw, config); });
}

TEST_CASE("model and RTL of a tri that shares multipliers make the same moves in every format",
          "[tri][lockstep][interval][slow]") {
    const Config config =
        format(GENERATE("every4:default", "every2:fast:default", "every2:fast:small", "every4:fast:small",
                        "every2:narrow", "every4:narrow", "every4:fast:narrow", "every2:wide", "every4:wide",
                        "every4:fast:wide", "every2:sheared:default", "every4:fast:sheared:default"));
    for (const Pace& pace : paces)
        check_lockstep<TriUnit>(config, {}, pace, 17, 1500 * config.tri_interval,
                                [&](Draw& draw) { return random_tri_req(draw, config); });
}

TEST_CASE("model and RTL of the sheared tri make the same moves in every cycle", "[tri][lockstep][sheared]") {
    const Config config =
        format(GENERATE("sheared:default", "sheared:small", "sheared:narrow", "sheared:wide"));
    for (const Pace& pace : paces)
        for (unsigned seed = 11; seed <= 13; ++seed)
            check_lockstep<TriUnit>(config, {}, pace, seed, 1500,
                                    [&](Draw& draw) { return random_tri_req(draw, config); });
}

}   // namespace rayclock::test::tri_test
