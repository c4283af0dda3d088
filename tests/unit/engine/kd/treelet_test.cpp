// treelet: compares the exits that a ray meets with exact planes.
#include "tests/support/cases/treelet_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

Config kd_format(const std::string& name) {
    Config config = format(name);
    config.structure = Structure::kd;
    return config;
}

TreeletReq random_req(Draw& draw, const Config& config) { return random_treelet_case(draw, config).req; }

}   // namespace

TEMPLATE_TEST_CASE("treelet loses no exit that the ray meets and takes few others", "[treelet]",
                   Model<TreeletUnit>, Rtl<TreeletUnit>) {
    const std::string name = GENERATE(as<std::string>{}, "default", "shading:narrow");
    const Config config = kd_format(name);
    for (unsigned seed = 1; seed <= 4; ++seed) {
        INFO(name << ", seed " << seed);
        Draw draw{seed};
        std::deque<TreeletCase> cases;
        TestType dut{config, Frame{}, int(seed)};
        stream(
            dut, config, flows[seed - 1], draw, 1500,
            [&](Draw& from) {
                cases.push_back(random_treelet_case(from, config));
                return cases.back().req;
            },
            [&](const TreeletReq&, const BoxRsp& rsp) {
                judge(cases.front(), rsp, config);
                cases.pop_front();
            });
    }
}

TEST_CASE("treelet is right for every plane and origin of one axis, on planes and half-way", "[treelet]") {
    Config config = kd_format("default");
    config.coord_bits = config.dir_bits = 12;
    config.node_width = 2;
    config.recip_bits = 8;
    const bool shades = GENERATE(false, true);
    config.shading = shades;
    config.origin_bits = 3;
    const int frac = config.origin_frac();
    for (const int d : {1, -1, 2, 3, -5, 7, -64, 100, 2047, -2048, 0})
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (int at = -3; at <= 3; ++at)
                for (int o = -4 * (1 << frac); o <= 5 * (1 << frac); ++o) {
                    TreeletCase c;
                    c.d[axis] = d;
                    c.req.o[axis] = o;
                    c.req.treelet.axis[0] = std::uint32_t(axis);
                    c.req.treelet.at[0] = at;
                    c.req.treelet.kind = {2, 1};
                    c.req.treelet.open = 1;
                    set_reciprocals(c, config);
                    for (std::size_t k = 0; k < 3; ++k) c.req.neg[k] = c.d[k] < 0;
                    CAPTURE(d, axis, at, o);
                    judge(c, treelet(c.req, config), config);
                }
}

TEST_CASE("model and rtl of treelet make the same moves in every cycle", "[treelet][lockstep]") {
    const Config config = kd_format(GENERATE("default", "shading:narrow"));
    for (const Flow& flow : flows)
        for (unsigned seed = 11; seed <= 12; ++seed)
            check_lockstep<TreeletUnit>(config, {}, flow, seed, 2000,
                                        [&](Draw& draw) { return random_req(draw, config); });
}

TEST_CASE("model and rtl of a fast treelet make the same moves in every cycle", "[treelet][lockstep][fast]") {
    const Config config = kd_format("fast:default");
    for (const Flow& flow : flows)
        check_lockstep<TreeletUnit>(config, {}, flow, 11, 2000,
                                    [&](Draw& draw) { return random_req(draw, config); });
}

TEST_CASE("treelet is right at both ends of every width", "[treelet]") {
    const std::string name = GENERATE(as<std::string>{}, "default", "shading:narrow", "broad");
    INFO(name);
    const Config config = kd_format(name);
    Draw draw{7};
    for (int i = 0; i < 3000; ++i) {
        const auto c = treelet_case_at_ends(draw, config);
        judge(c, treelet(c.req, config), config);
    }
}

TEST_CASE("model and rtl of treelet make the same moves at both ends of every width", "[treelet][lockstep]") {
    const Config config = kd_format(GENERATE("default", "shading:narrow", "fast:default"));
    for (unsigned seed = 21; seed <= 22; ++seed)
        check_lockstep<TreeletUnit>(config, {}, flows[0], seed, 4000,
                                    [&](Draw& draw) { return treelet_case_at_ends(draw, config).req; });
}

TEMPLATE_TEST_CASE("treelet answers after exactly its latency, and takes one in every cycle", "[treelet]",
                   Model<TreeletUnit>, Rtl<TreeletUnit>) {
    const Config config = kd_format(GENERATE("default", "fast:default"));
    TestType dut{config};
    check_latency(dut, config, [&](Draw& draw) { return random_req(draw, config); });
    TestType again{config};
    check_throughput(again, config, [&](Draw& draw) { return random_req(draw, config); });
}
