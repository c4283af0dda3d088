// tex: the address of a hit's texels, and their colour. Judges model and RTL by exact integers in every
// cycle, and compares them.
#include <catch2/catch.hpp>

#include "tests/support/dut/tex_dut.hpp"
#include "tests/support/world/traffic.hpp"

namespace rayclock::test::tex_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct Run {
    const char* config;
    unsigned seed;
    int hits;
};
const std::vector<Run> runs{{"rgb888", 1, 3000}, {"rgb565", 2, 3000}, {"narrow", 3, 1500}, {"fine", 4, 1500}};

}   // namespace

TEMPLATE_TEST_CASE("tex finds and filters the texels of every hit exactly", "[tex]", TexModel, TexRtl) {
    const Run run = GENERATE(from_range(runs));
    const Config config = tex_config(run.config);
    std::array<int, 13> levels{};
    int overtaken = 0, clamped = 0, mixed = 0;
    std::array<std::size_t, 3> codes{};
    std::array<std::vector<bool>, 3> seen{std::vector<bool>(256), std::vector<bool>(256),
                                          std::vector<bool>(256)};
    for (unsigned number = 0; number < flows.size(); ++number) {
        const Flow& flow = flows[number];
        const Frame frame = tex_frame(number);
        TestType dut{config, frame, int(run.seed)};
        TexWorld world{config, frame, run.seed + number, flow.idle_percent, flow.stall_percent};
        TexJudge judge{config, frame};
        for (int cycle = 0; world.answered < run.hits; ++cycle) {
            INFO(run.config << ", " << flow.name << ", cycle " << cycle << ", hit " << world.answered);
            REQUIRE(cycle < 60 * run.hits);
            world.drive(dut);
            dut.eval();
            judge.check(dut);
            world.take_over(dut);
            dut.commit();
        }
        for (std::size_t i = 0; i < levels.size(); ++i) levels[i] += judge.levels[i];
        overtaken += judge.overtaken, clamped += judge.clamped, mixed += judge.mixed;
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 256; ++i) seen[k][i] = seen[k][i] || judge.codes[k][i];
    }
    for (std::size_t k = 0; k < 3; ++k) codes[k] = std::size_t(std::ranges::count(seen[k], true));
    for (std::size_t i = 0; i < levels.size(); ++i) {
        INFO("level " << i);
        CHECK(levels[i] > 20);
    }
    CHECK((overtaken > 100 && clamped > 200 && mixed > 1000));
    if (run.hits >= 3000)
        CHECK(codes == (config.texels == TexelFormat::rgb888 ? std::array<std::size_t, 3>{256, 256, 256}
                                                             : std::array<std::size_t, 3>{32, 64, 32}));
}

TEST_CASE("model and RTL of tex do the same in every cycle", "[tex][lockstep]") {
    const Run run = GENERATE(from_range(runs));
    const Config config = tex_config(run.config);
    for (unsigned number = 0; number < flows.size(); ++number) {
        const Flow& flow = flows[number];
        const Frame frame = tex_frame(number + 1);
        TexModel model{config, frame};
        TexRtl rtl{config, frame, int(run.seed) + 5};
        TexWorld world{config, frame, run.seed + 20 + number, flow.idle_percent, flow.stall_percent};
        for (int cycle = 0; cycle < 3000; ++cycle) {
            INFO(run.config << ", " << flow.name << ", cycle " << cycle << ", hit " << world.answered);
            world.drive(model);
            static_cast<TexLinks&>(rtl) = model;
            model.eval();
            rtl.eval();
            REQUIRE(same(model.req, rtl.req, config));
            REQUIRE(same(model.texel_req, rtl.texel_req, config));
            REQUIRE(same(model.rsp, rtl.rsp, config));
            REQUIRE(model.texel_rsp.ready == rtl.texel_rsp.ready);
            REQUIRE(model.cause == rtl.cause);
            world.take_over(model);
            model.commit();
            rtl.commit();
        }
        CHECK(world.answered > 3000 / (config.contexts < 8 ? 100 : 20));
    }
}

TEST_CASE("a logarithm is the floor of the piecewise linear one, within its bound of the exact one",
          "[tex][log]") {
    const auto judge = [](std::uint32_t x) {
        const auto log = log_of(x);
        if (log != std::uint32_t(log_in_16ths(x))) FAIL("log of " << x << " is not " << log);
        if (x == 0) return;
        const double exact = std::log2(double(x)), got = std::ldexp(double(log), -level_frac);
        if (got > exact + 1e-12 || got < exact - 0.0861 - 0.0625) FAIL("log of " << x << " is " << got);
    };
    for (std::uint32_t x = 0; x < 1u << 20; ++x) judge(x);
    Draw draw{5};
    for (int i = 0; i < 100000; ++i) judge(std::uint32_t(draw.natural(32)));
    judge(~0u);
}

TEST_CASE("the rtl's logarithm is the floor of the piecewise linear one", "[tex][log][rtl]") {
    RtlModule rtl(tex_config("rgb888"), "rc_log");
    for (std::uint32_t x = 0; x < 1u << 16; ++x) {
        std::memcpy(rtl.port("x").data, &x, rtl.port("x").bytes);
        rtl.settle();
        std::uint32_t log = 0;
        std::memcpy(&log, rtl.port("log").data, rtl.port("log").bytes);
        if (log != std::uint32_t(log_in_16ths(x))) FAIL("log of " << x << " is not " << log);
    }
}

TEST_CASE("an intensity is the nearest to that of its sRGB code, and no code lies near a tie",
          "[tex][srgb]") {
    for (std::uint32_t code = 0; code < 256; ++code) {
        const long double exact = linear_of(code) * (1 << share_bits);
        INFO("code " << code);
        CHECK(std::fabs(exact - std::floor(exact) - 0.5L) > 1e-6L);
        CHECK(srgb_table()[code] == std::uint32_t(std::floor(exact + 0.5L)));
        CHECK(intensity_of(code) == int(std::floor(exact + 0.5L)));
    }
    CHECK((srgb_table()[0] == 0 && srgb_table()[255] == 1u << share_bits));
}

TEST_CASE("a level lies within its bound of the exact logarithm", "[tex][level]") {
    const Config config = tex_config("rgb888");
    Draw draw{9};
    int inside = 0;
    double low = 0, high = 0;
    for (int i = 0; i < 300000; ++i) {
        const TexReq hit = random_hit(draw, config);
        const int spread = tex_frame(unsigned(draw.below(4))).shade.spread;
        TexRecord record = random_record(draw, config);
        if (draw.percent(80)) aim_level(draw, hit, record, spread);
        const double exact = (record.density + spread) / 16.0 + std::log2(std::max(hit.path, 1u)) +
                             (unit_bits - std::log2(std::max(hit.cosine, 1u))) / 2;
        const auto level = double(level_of(hit, record, spread));
        // Two logarithms are at most 0.0861 + 1/16 too small, and half the second one counts. Then half of it
        // is rounded down to 1/16.
        constexpr double most_above = (0.0861 + 0.0625) / 2, most_below = 0.0861 + 0.0625 + 0.0625;
        const double last = record.last_level, error = level - exact;
        if (level > 0 && error > 0.5 + most_above) FAIL("level " << level << " for " << exact);
        if (level < last && error < -0.5 - most_below) FAIL("level " << level << " for " << exact);
        if (level > 0 && level < last) {
            ++inside;
            low = std::min(low, error), high = std::max(high, error);
        }
    }
    INFO(low << " " << high << ", inside " << inside);
    CHECK(inside > 30000);
    CHECK((low < -0.6 && high > 0.52));   // the draws come near the bounds
}

TEST_CASE("a texel that is written is read, and no other changes", "[tex][texel]") {
    const TexelFormat format = GENERATE(TexelFormat::rgb888, TexelFormat::rgb565);
    const WantedTile tile = wanted_tile(format);
    Draw draw{3};
    const auto same_but_for = [&](const Line& a, const Line& b, int x, int y) {
        for (int row = 0; row <= tile.height; ++row)
            for (int column = 0; column <= tile.width; ++column)
                if ((row != y || column != x) &&
                    texel_bits(a, column, row, format) != texel_bits(b, column, row, format))
                    return false;
        return true;
    };
    for (int i = 0; i < 2000; ++i) {
        const Line before = random_texels(draw);
        Line line = before;
        const int x = draw.between(0, tile.width), y = draw.between(0, tile.height);
        std::array<std::uint8_t, 4> texel{};
        for (auto& code : texel) code = std::uint8_t(draw.natural(8));
        put_texel(line, std::uint32_t(x), std::uint32_t(y), texel, format);
        REQUIRE(same_but_for(before, line, x, y));
        const std::uint32_t bits = texel_bits(line, x, y, format);
        const TexelCode read = texel_of(line, std::uint32_t(x), std::uint32_t(y), format);
        for (std::size_t k = 0; k < 3; ++k) {
            REQUIRE(read.code[k] == texel_code(bits, k, format));
            // The nearest code that the format has, expanded to 8 bits with an error below 1.
            const int most = format == TexelFormat::rgb888 ? 0 : k == 1 ? 3 : 5;
            REQUIRE(std::abs(int(read.code[k]) - int(texel[k])) <= most);
        }
        REQUIRE(read.alpha == (format == TexelFormat::rgb888 ? texel[3] : texel[3] >= 128 ? 255u : 0u));
    }
}

}   // namespace rayclock::test::tex_test
