// power: Phong's highlight, judged by long double, and its RTL against the model.
#include <cmath>

#include "model/core/config.hpp"
#include "model/fixed/power.hpp"
#include "model/fixed/square_root.hpp"
#include "model/fixed/tables.hpp"
#include "tests/support/dut/cell.hpp"

namespace rayclock::test::power_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct Operands {
    std::uint32_t c = 0, n = 0;
};
Operands draw_operands(Draw& draw) {
    std::uint32_t c = std::uint32_t(draw.natural(16));
    if (draw.percent(40)) c = 65536 - c % (1u << draw.between(1, 16));   // near 1, where the exponent decides
    return {c, std::uint32_t(draw.percent(40) ? draw.natural(shine_bits)
                                              : draw.bits(draw.between(1, shine_bits)))};
}

void put(RtlModule& rtl, const char* name, std::uint32_t value) {
    std::memcpy(rtl.port(name).data, &value, rtl.port(name).bytes);
}

}   // namespace

TEST_CASE("the tables of logarithm and power are rounded right", "[power]") {
    for (std::size_t i = 0; i < log_entries; ++i)
        REQUIRE(log_table()[i].value == std::llround(262144 * std::log2(1 + (long double)(i) / 128)));
    for (std::size_t i = 0; i < exp_entries; ++i)
        REQUIRE(exp_table()[i].value == std::llround(131072 * std::exp2(-(long double)(i) / 128)));
    REQUIRE(log_table().back().value + log_table().back().step == 1u << 18);
    REQUIRE(exp_table().back().value - exp_table().back().step == 1u << 16);
}

TEST_CASE("a power errs within its bound", "[power]") {
    long double most = 0;
    int inside = 0;
    const auto judge = [&](std::uint32_t c, std::uint32_t n) {
        const long double truth = 65536 * std::pow((long double)(c) / 65536, (long double)(n) / 16);
        const long double answer = power(c, n), share = (long double)(n) / 16384;
        if (answer < (1 - 1.1e-2L * share) * truth - 1 || answer > (1 + 1.4e-3L * share) * truth + 2)
            FAIL(c << " to the " << n << " / 16");
        most = std::max(most, std::fabs(answer - truth));
        inside += truth > 1 && truth < 65000;
    };
    for (std::uint32_t n = 0; n < 1u << shine_bits; n += 1 + n / 8)
        for (std::uint32_t c = 1; c <= 65536; c += c < 64000 ? 97 : 1) judge(c, n);
    for (std::uint32_t c = 1; c <= 65536; ++c)
        for (const std::uint32_t n : {1u, 16u, 100u, 16383u}) judge(c, n);
    INFO(most);
    REQUIRE(most < 256);
    REQUIRE(inside > 10000);
}

TEST_CASE("powers of nothing and of one, to the first and to none", "[power]") {
    for (std::uint32_t n = 0; n < 1u << shine_bits; ++n) {
        REQUIRE(power(0, n) == 0);
        REQUIRE(power(65536, n) == 65536);
    }
    for (std::uint32_t c = 1; c <= 65536; ++c) REQUIRE(power(c, 0) == 65536);
}

TEST_CASE("the RTL's power is the model's, after exactly its latency, one in a cycle", "[power][lockstep]") {
    for (const bool idle : {false, true})
        for (unsigned seed = 21; seed <= 23; ++seed)
            check_cell(
                {}, "rc_power", "power", power_stages, seed, 40000, idle, draw_operands,
                [](RtlModule& rtl, const Operands& o) {
                    put(rtl, "c", o.c);
                    put(rtl, "n", o.n);
                },
                [](const Operands& o) { return Words{power(o.c, o.n)}; });
}

TEST_CASE("square_root is the floor of the root", "[square_root]") {
    Draw draw{31};
    const auto judge = [](std::uint64_t x) {
        const std::uint64_t root = square_root(x);
        if (root * root > x || (root + 1) * (root + 1) <= x) FAIL("root of " << x << " is not " << root);
    };
    for (std::uint64_t x = 0; x < 100000; ++x) judge(x);
    for (std::uint64_t root = 1; root < (std::uint64_t(1) << 17); root += 3)
        for (const std::uint64_t x : {root * root - 1, root * root, root * root + 1}) judge(x);
    for (int i = 0; i < 100000; ++i) judge(draw.natural(33));
}

}   // namespace rayclock::test::power_test
