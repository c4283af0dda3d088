// box: compares the slab test of a node's children with exact intervals.
#include "tests/support/cases/box_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

BoxReq random_req(Draw& draw, const Config& config) { return random_box_case(draw, config).req; }

template <class Dut> void against_oracle(const char* name, unsigned seed, const Pace& pace, int count) {
    const Config config = format(name);
    INFO(name << ", seed " << seed);
    Draw draw{seed};
    std::deque<BoxCase> cases;
    Dut dut{config, Frame{}, int(seed)};
    stream(
        dut, config, pace, draw, count,
        [&](Draw& from) {
            cases.push_back(random_box_case(from, config));
            return cases.back().req;
        },
        [&](const BoxReq&, const NodeAnswer& rsp) {
            judge(cases.front(), rsp, config);
            cases.pop_front();
        });
}

/// Returns a format small enough to test everything.
Config tiny() {
    Config config;
    config.name = "tiny";
    config.coord_bits = config.dir_bits = 12;
    config.recip_bits = 8;
    config.box_bits = 4;
    return config;
}

void same_moves(const Config& config) {
    for (const Pace& pace : paces)
        for (unsigned seed = 11; seed <= 13; ++seed)
            check_lockstep<BoxUnit>(config, {}, pace, seed, 2000,
                                    [&](Draw& draw) { return random_req(draw, config); });
}

}   // namespace

TEMPLATE_TEST_CASE("box loses no child that the ray meets and keeps few others", "[box]", Model<BoxUnit>,
                   Rtl<BoxUnit>) {
    const auto name = GENERATE("default", "small", "narrow", "wide");
    for (unsigned seed = 1; seed <= 4; ++seed) against_oracle<TestType>(name, seed, paces[seed - 1], 1500);
}

TEMPLATE_TEST_CASE("box loses no child that the ray meets, many draws", "[box][slow]", Model<BoxUnit>,
                   Rtl<BoxUnit>) {
    const auto name = GENERATE("default", "small", "narrow", "wide");
    for (unsigned seed = 101; seed <= 110; ++seed)
        against_oracle<TestType>(name, seed, paces[seed % 4], 2000);
}

TEMPLATE_TEST_CASE("box loses no child that a bounce or a shadow ray meets and keeps few others",
                   "[box][shading]", Model<BoxUnit>, Rtl<BoxUnit>) {
    const auto name = GENERATE("shading:default", "shading:narrow");
    for (unsigned seed = 1; seed <= 4; ++seed) against_oracle<TestType>(name, seed, paces[seed - 1], 1500);
}

TEMPLATE_TEST_CASE("box loses no child that a bounce or a shadow ray meets, other formats",
                   "[box][shading][slow]", Model<BoxUnit>, Rtl<BoxUnit>) {
    const auto name = GENERATE("shading:small", "shading:wide", "shading:coarse");
    for (unsigned seed = 1; seed <= 4; ++seed) against_oracle<TestType>(name, seed, paces[seed - 1], 1500);
}

TEST_CASE("box is right for every pair of planes of one axis", "[box]") {
    const Config config = tiny();
    const auto direction = GENERATE(1, -1, 2, 3, -5, 7, -64, 100, 2047, -2048, 0);
    const auto axis = GENERATE(as<std::size_t>{}, 0, 1, 2);
    for (const std::uint32_t e : {0u, 1u, 3u, 9u})
        for (int o = -9; o <= 9; o += e == 9 ? 3 : 1) {
            BoxCase c;
            c.req.o[axis] = o * (1 << e) + (e > 0 ? o % 3 : 0);
            if (c.req.o[axis] < -2048 || c.req.o[axis] > 2047) continue;
            Vec3i d{};
            d[axis] = direction;
            set_direction(c, d, config);
            c.req.node.org[axis] = -8;
            c.req.node.exp[axis] = e;
            const auto judge_children = [&](std::uint32_t children) {
                for (std::size_t i = 0; i < max_width; ++i) c.req.node.kind[i] = i < children;
                CAPTURE(e, c.req.o[axis]);
                judge(c, box(c.req, config), config);
            };
            std::uint32_t child = 0;
            for (std::uint32_t lo = 0; lo < 16; ++lo)
                for (std::uint32_t hi = lo; hi < 16; ++hi) {
                    c.req.node.lo[3 * child + axis] = lo;
                    c.req.node.hi[3 * child + axis] = hi;
                    if (++child < 8) continue;
                    judge_children(child);
                    child = 0;
                }
            if (child > 0) judge_children(child);
        }
}

TEST_CASE("box sees a ray that starts on a face or inside at distance 0", "[box]") {
    const Config config = tiny();
    BoxCase c;
    c.req.node.kind[0] = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        c.req.node.org[k] = -8;
        c.req.node.exp[k] = 1;
        c.req.node.hi[k] = 8;   // -8 .. 8
    }
    for (const int x : {-8, 0, 8})
        for (const int y : {-8, 0, 8})
            for (const int z : {-8, 0, 8})
                for (int way = 1; way < 27; ++way) {
                    c.req.o = {x, y, z};
                    set_direction(c, {(way % 3 - 1) * 700, (way / 3 % 3 - 1) * 1, (way / 9 - 1) * -2048},
                                  config);
                    const NodeAnswer rsp = box(c.req, config);
                    REQUIRE(rsp.inner == 1);
                    REQUIRE(rsp.t_near[0] == 0);
                }
}

TEMPLATE_TEST_CASE("box answers after exactly its latency", "[box][long]", Model<BoxUnit>, Rtl<BoxUnit>) {
    const Config config = format(GENERATE("default", "narrow", "fast:default", "lanes4:default",
                                          "lanes1:default", "lanes2:fast:default", "lanes1:fast:default"));
    TestType dut{config};
    check_latency(dut, config, [&](Draw& draw) { return random_req(draw, config); });
}

TEMPLATE_TEST_CASE("box accepts a node in every cycle, or every few", "[box][long]", Model<BoxUnit>,
                   Rtl<BoxUnit>) {
    const Config config = format(GENERATE("default", "wide", "fast:default", "lanes4:default",
                                          "lanes1:default", "lanes2:fast:default", "lanes1:fast:default"));
    TestType dut{config};
    check_throughput(dut, config, [&](Draw& draw) { return random_req(draw, config); });
}

TEST_CASE("model and RTL of box make the same moves in every cycle", "[box][lockstep]") {
    same_moves(format(GENERATE("default", "small", "narrow", "wide")));
}

TEST_CASE("model and RTL of a fast box make the same moves in every cycle", "[box][lockstep][fast][long]") {
    same_moves(format(GENERATE("fast:default", "fast:small", "fast:shading:narrow")));
}

TEST_CASE("model and RTL of a box of few lanes make the same moves in every cycle",
          "[box][lockstep][lanes]") {
    same_moves(format(GENERATE("lanes2:default", "lanes1:fast:default")));
}

TEST_CASE("model and RTL of a box of few lanes make the same moves in every format",
          "[box][lockstep][lanes][slow]") {
    same_moves(format(GENERATE("lanes1:default", "lanes4:default", "lanes4:fast:default",
                               "lanes2:fast:default", "lanes1:small", "lanes2:fast:small", "lanes2:wide",
                               "lanes1:shading:narrow", "lanes2:fast:shading:default")));
}

TEST_CASE("model and RTL of box make the same moves in every cycle with bounces and shadow rays",
          "[box][lockstep][shading]") {
    same_moves(format(GENERATE("shading:default", "shading:narrow")));
}

TEST_CASE("model and RTL of box make the same moves with bounces and shadow rays, other formats",
          "[box][lockstep][shading][slow]") {
    same_moves(format(GENERATE("shading:small", "shading:wide", "shading:coarse")));
}
