// globe: compares the bounding spheres that a ray meets with exact geometry.
#include "tests/support/cases/node_unit.hpp"
#include "tests/support/cases/globe_cases.hpp"

#include "model/engine/spheres/tables.hpp"
#include "tests/support/machine/build_all.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

Config globe_format(const std::string& name) {
    Config config = format(name);
    config.structure = Structure::spheres;
    if (config.timing == Timing::fast) config.box_queue = 64;   // it has more stages than box
    return config;
}

}   // namespace

TEST_CASE("the RTL of globe builds", "[.build]") {
    REQUIRE_NOTHROW(build_all({{"rc_globe", "default", globe_format("default")},
                               {"rc_globe", "shading:narrow", globe_format("shading:narrow")},
                               {"rc_globe", "fast:default", globe_format("fast:default")}}));
}

TEMPLATE_TEST_CASE("globe loses no child that the ray meets and keeps few others", "[globe]",
                   Model<GlobeUnit>, Rtl<GlobeUnit>) {
    check_judged<TestType>(globe_format(GENERATE("default", "shading:narrow")), random_globe_case);
}

TEST_CASE("globe is right in every format", "[globe]") {
    const std::string name = GENERATE(as<std::string>{}, "small", "narrow", "wide", "coarse", "sheared:small",
                                      "shading:default", "shading:small");
    INFO(name);
    const Config config = globe_format(name);
    Draw draw{5};
    for (int i = 0; i < 3000; ++i) {
        const GlobeCase c = random_globe_case(draw, config);
        judge(c, globe(c.req, config), config);
    }
}

TEST_CASE("globe is right for every small ray, from everywhere around a globe and in it", "[globe][long]") {
    Config config = globe_format("default");
    config.coord_bits = config.dir_bits = 12;
    config.node_width = 2;
    config.shading = GENERATE(0, 1);
    config.origin_bits = 2;
    GlobeCase c;
    c.req.node.kind = {1, 1};
    c.req.node.radius = {2, 3};
    c.req.node.centre = {3, 3, 3, 0, 2, 4};
    for (std::uint32_t exp = 0; exp < 2; ++exp)
        for (int o = 0; o < 11 * 11 * 11; ++o)
            for (int d = 0; d < 5 * 5 * 5; ++d) {
                if (d == 62) continue;   // not a direction
                c.req.node.exp = exp;
                const Vec3i from{o % 11 - 3, o / 11 % 11 - 3, o / 121 - 3};
                Vec3i at = ray_origin(from, config);
                if (config.shading) at[0] += o % 4, at[1] += d % 4;
                c.ray = make_ray(at, {d % 5 - 2, d / 5 % 5 - 2, d / 25 - 2}, config,
                                 config.shading ? RayKind::bounce : RayKind::camera);
                const GlobeRay ray = globe_ray(c.ray, config);
                c.req.o = ray.o, c.req.toward = ray.toward, c.req.len = ray.len;
                const NodeAnswer rsp = globe(c.req, config);
                for (std::size_t i = 0; i < 2; ++i) {
                    const GlobeSight exact = sight_of(c, i, config);
                    if (!exact.is_met()) continue;
                    const bool first = rsp.inner > 0 && rsp.offset[0] == 2 * i;
                    const bool there = first || (rsp.inner > 1 && rsp.offset[1] == 2 * i);
                    CAPTURE(exp, o, d, i);
                    REQUIRE(there);
                    const oracle::Rational unit =
                        oracle::power_of_two(config.dir_bits - 1 + config.t_frac_bits);
                    REQUIRE(exact.is_before(oracle::Int(rsp.t_near[first ? 0 : 1]) / unit));
                }
            }
}

TEST_CASE("globe's tables are on their side, and near", "[globe]") {
    for (std::uint64_t z = 1 << 16; z < 1 << 17; ++z) {
        const TableEntry& entry = near_inverse_table()[(z >> 9) - 128];
        const std::uint64_t value = entry.value - (entry.step * (z & 511) >> 9);
        const std::uint64_t most = (std::uint64_t(1) << 33) - (std::uint64_t(1) << 17);
        REQUIRE(value * (z + 1) <= most);
        REQUIRE((value + 6) * (z + 1) > most);
        REQUIRE(entry.value >> near_inverse_bits == 0);
        REQUIRE(entry.step >> near_inverse_step_bits == 0);
    }
    for (std::uint32_t i = 64; i < 256; ++i) {
        const std::uint32_t root = root_up_table()[i - 64].value;
        REQUIRE(root * root >= (i + 1) << 10);
        REQUIRE((root - 1) * (root - 1) < (i + 1) << 10);
        REQUIRE(root >> root_up_bits == 0);
    }
}

TEST_CASE("model and RTL of globe make the same moves in every cycle", "[globe][lockstep]") {
    check_moves<GlobeUnit>(globe_format(GENERATE("default", "shading:narrow")), {11, 12}, random_globe_case);
}

TEST_CASE("model and RTL of a fast globe make the same moves in every cycle", "[globe][lockstep][fast]") {
    check_moves<GlobeUnit>(globe_format("fast:default"), {11}, random_globe_case);
}

TEST_CASE("globe is right at both ends of every width", "[globe]") {
    const std::string name = GENERATE(as<std::string>{}, "default", "shading:narrow", "wide");
    INFO(name);
    const Config config = globe_format(name);
    Draw draw{7};
    for (int i = 0; i < 3000; ++i) {
        const auto c = globe_case_at_ends(draw, config);
        // Nothing is lost. How loose the answer may be is not proven here.
        judge(c, globe(c.req, config), config, false);
    }
}

TEST_CASE("model and RTL of globe make the same moves at both ends of every width", "[globe][lockstep]") {
    check_moves_at_ends<GlobeUnit>(globe_format(GENERATE("default", "shading:narrow", "fast:default")),
                                   globe_case_at_ends);
}

TEMPLATE_TEST_CASE("globe answers after exactly its latency, and accepts a request in every cycle", "[globe]",
                   Model<GlobeUnit>, Rtl<GlobeUnit>) {
    check_pace<TestType>(globe_format(GENERATE("default", "fast:default")), random_globe_case);
}
