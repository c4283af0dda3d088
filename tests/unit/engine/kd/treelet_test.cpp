// treelet: compares the exits that a ray meets with exact planes.
#include "tests/support/cases/node_unit.hpp"
#include "tests/support/cases/treelet_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

Config kd_format(const std::string& name) {
    Config config = format(name);
    config.structure = Structure::kd;
    return config;
}

}   // namespace

TEMPLATE_TEST_CASE("treelet loses no exit that the ray meets and keeps few others", "[treelet][long]",
                   Model<TreeletUnit>, Rtl<TreeletUnit>) {
    check_judged<TestType>(kd_format(GENERATE("default", "shading:narrow")), random_treelet_case);
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
                    c.req.node.axis[0] = std::uint32_t(axis);
                    c.req.node.at[0] = at;
                    c.req.node.kind = {2, 1};
                    c.req.node.open = 1;
                    set_reciprocals(c, config);
                    for (std::size_t k = 0; k < 3; ++k) c.req.neg[k] = c.d[k] < 0;
                    CAPTURE(d, axis, at, o);
                    judge(c, treelet(c.req, config), config);
                }
}

TEST_CASE("model and RTL of treelet make the same moves in every cycle", "[treelet][lockstep]") {
    check_moves<TreeletUnit>(kd_format(GENERATE("default", "shading:narrow")), {11, 12}, random_treelet_case);
}

TEST_CASE("model and RTL of a fast treelet make the same moves in every cycle",
          "[treelet][lockstep][fast][long]") {
    check_moves<TreeletUnit>(kd_format("fast:default"), {11}, random_treelet_case);
}

TEST_CASE("treelet is right at both ends of every width", "[treelet]") {
    check_answers<TreeletUnit>(kd_format(GENERATE("default", "shading:narrow", "wide")),
                               treelet_case_at_ends);
}

TEST_CASE("model and RTL of treelet make the same moves at both ends of every width", "[treelet][lockstep]") {
    check_moves_at_ends<TreeletUnit>(kd_format(GENERATE("default", "shading:narrow", "fast:default")),
                                     treelet_case_at_ends);
}

TEMPLATE_TEST_CASE("treelet answers after exactly its latency, and accepts a request in every cycle",
                   "[treelet]", Model<TreeletUnit>, Rtl<TreeletUnit>) {
    check_pace<TestType>(kd_format(GENERATE("default", "fast:default")), random_treelet_case);
}
