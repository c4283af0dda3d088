// unit_vector: a vector's direction, judged by long double, and its RTL against the model.
#include <cmath>

#include "model/fixed/tables.hpp"
#include "model/fixed/unit_vector.hpp"
#include "tests/support/dut/cell.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr int cell_bits = 44;   // the default width of rc_unit_vector's operands

/// Draws vectors of every length up to `bits`: corner cases, components much shorter than the longest, and
/// components whose lower 17 bits are nearly zero.
Vec3l draw_vector(Draw& draw, int bits) {
    const int longest = draw.between(2, bits);
    Vec3l v{};
    for (auto& x : v) x = draw.number(draw.percent(25) ? draw.between(2, longest) : longest);
    if (draw.percent(10) && longest > 18)
        for (auto& x : v) x |= (std::int64_t(1) << (longest - 18)) - 1;   // the largest possible truncation
    if (draw.percent(10)) v[1] = v[0];
    if (draw.percent(10)) v[2] = ~v[0] + (v[0] > 0);   // minus the least number would not fit
    return v;
}

}   // namespace

TEST_CASE("the inverse root errs within its bound for every operand", "[unit_vector]") {
    for (std::size_t i = 0; i < root_entries; ++i)
        REQUIRE(inverse_root_table()[i].value ==
                std::llround(262144.0L / std::sqrt(1 + (long double)(i) / 128)));
    REQUIRE(inverse_root_table().back().value - inverse_root_table().back().step == 131072);
    long double below = 0, above = 0, below_share = 0, above_share = 0;
    for (std::uint32_t sum = 0; sum < 3u << 17; ++sum)
        for (const std::uint32_t end : {sum, sum + 1}) {   // the true value falls from one end to the other
            const long double truth = 262144.0L / std::sqrt(1 + (long double)(end) / 131072),
                              error = inverse_root(sum) - truth;
            below = std::min(below, error), above = std::max(above, error);
            below_share = std::min(below_share, 65536 * error / truth),
            above_share = std::max(above_share, 65536 * error / truth);
        }
    INFO(below << " " << above << ", of itself " << below_share << " " << above_share);
    REQUIRE((below > -0.5L && above < 3.7L));
    REQUIRE((below_share > -0.24L && above_share < 0.91L));
}

TEST_CASE("a unit vector's components and length err within their bounds", "[unit_vector]") {
    long double most = 0, shortest = 0, longest = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        Draw draw{seed};
        for (int i = 0; i < 100000; ++i) {
            const Vec3l v = draw_vector(draw, 63);
            const Vec3i u = unit_vector(v);
            const long double length =
                std::hypot((long double)(v[0]), (long double)(v[1]), (long double)(v[2]));
            if (length == 0) {
                REQUIRE(u == Vec3i{});
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                most = std::max(most, std::fabs(u[k] - 65536 * (v[k] / length)));
                REQUIRE((std::abs(u[k]) <= 65536 && std::int64_t(u[k]) * (v[k] < 0 ? -1 : 1) >= 0));
            }
            const long double over =
                std::hypot((long double)(u[0]), (long double)(u[1]), (long double)(u[2])) - 65536;
            shortest = std::min(shortest, over), longest = std::max(longest, over);
        }
    }
    INFO(most << ", length " << shortest << " " << longest);
    REQUIRE((most < 3.2L && shortest > -1.12L && longest < 1.78L));
    REQUIRE((most > 1.2L && longest > 1));   // the draws come near the bounds
}

TEST_CASE("a unit vector does not depend on the scale, if nothing is cut", "[unit_vector]") {
    Draw draw{7};
    for (int i = 0; i < 20000; ++i) {
        const Vec3l v = draw_vector(draw, 17);
        const int shift = draw.between(1, 46);
        REQUIRE(unit_vector(v) == unit_vector({v[0] << shift, v[1] << shift, v[2] << shift}));
    }
    REQUIRE(unit_vector({0, 0, 0}) == Vec3i{});
    REQUIRE(unit_vector({1, 0, 0}) == Vec3i{65536, 0, 0});
    REQUIRE(unit_vector({0, -(std::int64_t(1) << 62), 0}) == Vec3i{0, -65536, 0});
}

TEST_CASE("the RTL's unit vector is the model's, after exactly its latency, one in a cycle",
          "[unit_vector][lockstep]") {
    for (const bool idle : {false, true})
        for (unsigned seed = 11; seed <= 13; ++seed)
            check_cell(
                {}, "rc_unit_vector", "u", unit_stages, seed, 20000, idle,
                [](Draw& draw) { return draw_vector(draw, cell_bits); },
                [](RtlModule& rtl, const Vec3l& v) {
                    Words words;
                    words.assign((3 * cell_bits + 31) / 32, 0);
                    PackVisitor pack{words, 3 * cell_bits};
                    pack("v", v, cell_bits, 3);
                    copy_words(rtl.port("v"), words);
                },
                [](const Vec3l& v) {
                    const Vec3i u = unit_vector(v);
                    Words words(2, 0);
                    PackVisitor pack{words, 54};
                    pack("u", u, 18, 3);
                    return words;
                });
}
