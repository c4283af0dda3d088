// The selectable ray-triangle tests: the choice of a test, and the baselines, which follow their papers and
// have their known leaks. The sheared test is in sheared_test.cpp.
#include "model/base/error.hpp"
#include "model/engine/check.hpp"
#include "model/unit/tri/baselines/unit24.hpp"
#include "tests/support/cases/primitive_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;
using Catch::Contains;

TEST_CASE("a primitive test is chosen by name", "[primitive]") {
    Config config;
    REQUIRE(config.test() == PrimitiveTest::exact);
    for (const std::string& name : names_of<PrimitiveTest>()) {
        set_parameter(config, "primitive_test", name, "f");
        REQUIRE(name_of(config.primitive_test) == name);
        check_config(config, "f");
        if (name == "exact" || name == "sheared")
            REQUIRE_NOTHROW(check_rtl(config));
        else
            REQUIRE_THROWS_WITH(check_rtl(config),
                                Contains("primitive_test=" + name) && Contains("software only"));
    }
    REQUIRE_THROWS_WITH(set_parameter(config, "primitive_test", "shared", "f"),
                        Contains("f: ") && Contains("'sheared'"));
    set_parameter(config, "primitive_test", "sheared", "f");
    config.dir_bits = config.coord_bits + 1;
    REQUIRE_THROWS_WITH(check_config(config, "f"),
                        Contains("f: ") && Contains("dir_bits") && Contains("20") && Contains("19"));
}

TEST_CASE("every test finds a hit far from edges, and where it is", "[primitive]") {
    const auto name = GENERATE("sheared", "unit24", "moller", "woop", "truncated");
    const Config config = with_test(name), exact = with_test("exact");
    const std::vector<PrimData> all = sphere(1, 65536);
    Draw draw{9};
    const double tolerance = std::string(name) == "truncated" ? 2e-2 : 3e-4;
    for (int i = 0; i < 2000; ++i) {
        const PrimData& t = all[std::size_t(draw.below(int(all.size())))];
        const double b = 0.15 + draw.below(400) / 1000.0, c = 0.15 + draw.below(300) / 1000.0;
        const auto target = inside(t, b, c);
        const Vec3i o = far_origin(draw, 18, 110000), d = towards(o, target, config.dir_bits);
        const double cosine = (target[0] * d[0] + target[1] * d[1] + target[2] * d[2]) /
                              std::hypot(target[0], target[1], target[2]) / std::hypot(d[0], d[1], d[2]);
        if (std::abs(cosine) < 0.3) continue;
        const TriRsp there = run_test(exact, o, d, t), here = run_test(config, o, d, t);
        CAPTURE(name, i);
        REQUIRE((there.closer && here.closer));
        REQUIRE(here.prim == t.prim);
        REQUIRE(here.t == Approx(double(there.t)).epsilon(tolerance));
        const double one = 1 << config.bary_bits;
        REQUIRE(here.u / one == Approx(there.u / one).margin(0.02));
        REQUIRE(here.v / one == Approx(there.v / one).margin(0.02));
        REQUIRE(here.num < std::int64_t(1) << (config.num_bits() - 1));
        REQUIRE(here.det < std::int64_t(1) << (config.edge_bits() - 1));
        // A hit beats a farther one and not a nearer one. Of equal hits the lower number wins.
        const Best same{1, here.num, here.det, t.prim}, nearer{1, here.num - here.num / 8, here.det, t.prim},
            farther{1, here.num + here.num / 8, here.det, 0};
        REQUIRE(run_test(config, o, d, t, same).closer == 1);
        REQUIRE(run_test(config, o, d, t, nearer).closer == 0);
        REQUIRE(run_test(config, o, d, t, farther).closer == 1);
        const Best lower{1, here.num, here.det, t.prim - 1};
        if (t.prim > 0) REQUIRE(run_test(config, o, d, t, lower).closer == 0);
    }
}

TEST_CASE("no test accepts a hit behind the origin, or a direction of zero", "[primitive]") {
    const auto name = GENERATE("exact", "sheared", "unit24", "moller", "woop", "truncated");
    const Config config = with_test(name);
    const PrimData t{{-40000, -40000, 1000}, {40000, -40000, 1000}, {0, 80000, 1000}, 5};
    REQUIRE(run_test(config, {0, 0, 0}, {0, 0, 100000}, t).closer == 1);
    REQUIRE(run_test(config, {0, 0, 0}, {0, 0, -100000}, t).closer == 0);
    REQUIRE(run_test(config, {0, 0, 2000}, {0, 0, 100000}, t).closer == 0);
    REQUIRE(run_test(config, {0, 0, 0}, {0, 0, 0}, t).closer == 0);
    REQUIRE(run_test(config, {0, 0, 0}, {100000, 0, 0}, t).closer == 0);
    const PrimData edge_on{{0, -100, 1000}, {0, 100, 1000}, {0, 0, 5000}, 5};
    REQUIRE(run_test(config, {0, 0, 0}, {0, 0, 100000}, edge_on).closer == 0);
}

TEST_CASE("a quad's diagonal is lost by Moller and Trumbore in float32, and by nothing exact",
          "[primitive]") {
    // The quad (-5, -5, 0) .. (5, 5, 0), 10 below the eye, and rays to its diagonal such as (0.30458447,
    // 0.30458447, -0.9024725). The diagonal lies opposite to both triangles' first corner: u + v is rounded,
    // and compared with 1.
    const std::int32_t k = 5 * 2003;
    const Vec3i o{0, 0, 2 * k}, p{-k, -k, 0}, q{k, -k, 0}, r{k, k, 0}, s{-k, k, 0};
    const auto taken = [&](const char* name, const Vec3i& d) {
        int n = 0;
        for (const PrimData& t : {PrimData{q, r, p, 1}, PrimData{s, p, r, 2}})
            n += int(run_test(with_test(name), o, d, t).closer);
        return n;
    };
    int lost = 0;
    Draw draw{3};
    for (int i = 0; i < 2000; ++i) {
        const double tilt = i == 0 ? 0.30458447 / 0.9024725 : draw.below(100000) / 250000.0;
        const Config config = with_test("exact");
        const std::int32_t down = (1 << (config.dir_bits - 1)) - 1 - draw.below(1000),
                           across = std::int32_t(std::lround(down * tilt));
        const Vec3i d{across, across, -down};
        CAPTURE(i, across, down);
        REQUIRE(taken("exact", d) == 1);
        REQUIRE(taken("sheared", d) == 1);
        lost += taken("moller", d) == 0;
    }
    CAPTURE(lost);
    REQUIRE(lost > 0);
}

TEST_CASE("24-bit floats are rounded to nearest, ties to even", "[primitive]") {
    REQUIRE(float24(1) == 1);
    REQUIRE(float24(131071) == 131071);   // 17 bits
    REQUIRE(float24(131073) == 131072);
    REQUIRE(float24(262146) == 262144);   // a tie, to even
    REQUIRE(float24(262150) == 262152);   // a tie, to even, upwards
    REQUIRE(float24(262147) == 262148);
    REQUIRE(float24(-262147) == -262148);
    REQUIRE(float24(262143) == 262144);   // carries
    REQUIRE(float24(0x1.ffffp63) == 0x1.ffffp63);
    REQUIRE(std::isinf(float24(0x1.ffff8p63)));
    REQUIRE(float24(0x1p-62) == 0x1p-62);
    REQUIRE(float24(0x1p-63) == 0);
    REQUIRE(float24(0) == 0);
    REQUIRE(std::isnan(float24(std::nan(""))));
}
