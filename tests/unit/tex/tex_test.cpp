// tex: the address of a hit's texels, and their colour. Compares model and RTL with exact integer rules in
// every cycle, and with each other.
#include <catch2/catch.hpp>

#include <boost/multiprecision/cpp_int.hpp>

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
const std::vector<Run> runs{{"rgb888", 1, 3000}, {"rgb565", 2, 3000}, {"narrow", 3, 1500}, {"fine", 4, 1500},
                            {"levels", 5, 1500}, {"planes", 6, 4000}, {"wide", 7, 1500}};

}   // namespace

TEMPLATE_TEST_CASE("tex finds and filters the texels of every hit exactly", "[tex]", TexModel, TexRtl) {
    const Run run = GENERATE(from_range(runs));
    const Config config = tex_config(run.config);
    std::array<int, 13> levels{};
    int overtaken = 0, clamped = 0, mixed = 0, holes = 0, edges = 0, below_edges = 0;
    std::array<std::size_t, 3> codes{};
    std::array<std::vector<bool>, 3> seen{std::vector<bool>(256), std::vector<bool>(256),
                                          std::vector<bool>(256)};
    for (unsigned number = 0; number < paces.size(); ++number) {
        const Pace& pace = paces[number];
        const Frame frame = tex_frame(number);
        TestType dut{config, frame, int(run.seed)};
        TexWorld world{config, frame, run.seed + number, pace.idle_percent, pace.stall_percent};
        TexJudge judge{config, frame};
        for (int cycle = 0; world.answered < run.hits; ++cycle) {
            INFO(run.config << ", " << pace.name << ", cycle " << cycle << ", hit " << world.answered);
            REQUIRE(cycle < 60 * run.hits);
            world.drive(dut);
            dut.eval();
            judge.check(dut);
            world.take_over(dut);
            dut.commit();
        }
        for (std::size_t i = 0; i < levels.size(); ++i) levels[i] += judge.levels[i];
        overtaken += judge.overtaken, clamped += judge.clamped, mixed += judge.mixed;
        holes += judge.holes, edges += judge.edges, below_edges += judge.below_edges;
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 256; ++i) seen[k][i] = seen[k][i] || judge.codes[k][i];
    }
    for (std::size_t k = 0; k < 3; ++k) codes[k] = std::size_t(std::ranges::count(seen[k], true));
    for (std::size_t i = 0; i < levels.size(); ++i) {
        INFO("level " << i);
        CHECK(levels[i] > 20);
    }
    CHECK((overtaken > 100 && clamped > 200 && mixed > 1000));
    CAPTURE(holes, edges, below_edges);
    CHECK((holes > run.hits / 4 && edges > run.hits / 50));
    // An alpha of one bit rarely lies just below the cut-off.
    CHECK((below_edges > run.hits / 50 || config.texels == TexelFormat::rgb565));
    if (run.hits >= 3000)
        CHECK(codes == (config.texels == TexelFormat::rgb888 ? std::array<std::size_t, 3>{256, 256, 256}
                                                             : std::array<std::size_t, 3>{32, 64, 32}));
}

TEST_CASE("model and RTL of tex do the same in every cycle", "[tex][lockstep]") {
    const Run run = GENERATE(from_range(runs));
    const Config config = tex_config(run.config);
    for (unsigned number = 0; number < paces.size(); ++number) {
        const Pace& pace = paces[number];
        const Frame frame = tex_frame(number + 1);
        TexModel model{config, frame};
        TexRtl rtl{config, frame, int(run.seed) + 5};
        TexWorld world{config, frame, run.seed + 20 + number, pace.idle_percent, pace.stall_percent};
        for (int cycle = 0; cycle < 3000; ++cycle) {
            INFO(run.config << ", " << pace.name << ", cycle " << cycle << ", hit " << world.answered);
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

TEST_CASE("the fractions of a logarithm are rounded to nearest, and none lies near a tie", "[tex][log]") {
    using boost::multiprecision::cpp_int;
    for (int i = 0; i < 32; ++i) {
        const long double exact = exact_log_in_64ths(i);
        INFO("part " << i << " is " << double(exact));
        CHECK(std::fabs(exact - std::floor(exact) - 0.5L) > 1e-6L);
        // f - 1/2 < 64 log2(m / 64) < f + 1/2, where m / 64 is the middle: as powers, 2^(2f - 1 + 768) <
        // m^128 < 2^(2f + 1 + 768).
        const unsigned f = log_fractions()[std::size_t(i)];
        const cpp_int power = pow(cpp_int(65 + 2 * i), 128);
        CHECK(2 * power > cpp_int(1) << (2 * f + 768));
        CHECK(power < cpp_int(1) << (2 * f + 1 + 768));
        CHECK(log_in_64ths(std::uint32_t(32 + i)) == int(5 * 64 + f));
    }
}

TEST_CASE("a part's numbers share the logarithm of its middle, within its bound", "[tex][log]") {
    double low = 0, high = 0;
    const auto judge = [&](std::uint32_t x) {
        const auto log = log_of(x);
        if (log != std::uint32_t(log_in_64ths(x))) FAIL("log of " << x << " is not " << log);
        if (x == 0) return;
        const double error = std::ldexp(double(log), -level_frac) - std::log2(double(x));
        low = std::min(low, error), high = std::max(high, error);
    };
    for (std::uint32_t x = 0; x < 1u << 20; ++x) judge(x);
    Draw draw{5};
    for (int i = 0; i < 100000; ++i) judge(std::uint32_t(draw.natural(32)));
    judge(~0u);
    INFO(low << " to " << high);
    CHECK((low > -0.031 && high < 0.031));
    CHECK((low < -0.02 && high > 0.02));
}

TEST_CASE("in the RTL all numbers of a part have the logarithm of its middle", "[tex][log][rtl]") {
    RtlModule rtl(tex_config("rgb888"), "rc_log");
    for (std::uint32_t x = 0; x < 1u << 16; ++x) {
        std::memcpy(rtl.port("x").data, &x, rtl.port("x").bytes);
        rtl.settle();
        std::uint32_t log = 0;
        std::memcpy(&log, rtl.port("log").data, rtl.port("log").bytes);
        if (log != std::uint32_t(log_in_64ths(x))) FAIL("log of " << x << " is not " << log);
    }
}

TEST_CASE("an intensity is the nearest number to its sRGB code's light, and no code lies near a tie",
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
    const Config config = tex_config(GENERATE("rgb888", "levels"));
    Draw draw{9};
    int inside = 0;
    double low = 0, high = 0;
    for (int i = 0; i < 300000; ++i) {
        const TexReq hit = random_hit(draw, config);
        const int spread = tex_frame(unsigned(draw.below(4))).shade.spread;
        TexRecord record = random_record(draw, config);
        if (draw.percent(80)) aim_level(draw, hit, record, spread);
        const double exact = (record.density + hit.scale + spread) / 64.0 +
                             std::log2(std::max(hit.path, 1u)) +
                             (unit_bits - std::log2(std::max(hit.cosine, 1u))) / 2;
        const auto level = double(level_of(hit, record, spread));
        if (hit.path == 0) {
            REQUIRE(level == 0);
            continue;
        }
        // Each logarithm errs by at most 0.031. The second one is halved, and then rounded down to 1/64.
        constexpr double most_above = 0.031 * 1.5, most_below = 0.031 * 1.5 + 1.0 / 64;
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
    CHECK((low < -0.52 && high > 0.52));   // the draws come near the bounds
}

TEST_CASE("a cosine of 1 adds nothing to the level, although its table entry is above log2(1)",
          "[tex][level]") {
    const std::uint32_t one = 1u << unit_bits;
    CHECK(log_of(one) > std::uint32_t(unit_bits << level_frac));
    TexRecord record;
    record.last_level = 12;
    for (std::uint32_t bit = 0; bit < 28; ++bit) {
        const TexReq hit{.path = 1u << bit, .cosine = one};
        const int log = log_in_64ths(hit.path);
        for (int level = 1; level < 12; ++level)
            for (const int beside : {-33, -32, 0, 31, 32}) {
                INFO("level " << level << ", path " << hit.path << ", beside it by " << beside);
                record.density = 64 * level - log + beside;
                const int wanted = beside < -32 ? level - 1 : beside < 32 ? level : level + 1;
                REQUIRE(int(level_of(hit, record, 0)) == wanted);
            }
    }
    for (std::uint32_t cosine = 0; cosine <= one; ++cosine) {
        // The level rises where the densities of this table meet the slant.
        const TexReq hit{.path = 1, .cosine = cosine};
        record.density = 64 * 2 + 31 - log_in_64ths(1) - slant_in_64ths(cosine);
        if (level_of(hit, record, 0) != 2) FAIL("cosine " << cosine << " adds too much");
        ++record.density;
        if (level_of(hit, record, 0) != 3) FAIL("cosine " << cosine << " adds too little");
    }
}

TEST_CASE("an instance's scale counts as the density does", "[tex][level]") {
    const Config config = tex_config("levels");
    Draw draw{31};
    int inside = 0;
    for (int i = 0; i < 50000; ++i) {
        TexReq hit = random_hit(draw, config);
        const int spread = tex_frame(unsigned(draw.below(4))).shade.spread;
        TexRecord record = random_record(draw, config);
        aim_level(draw, hit, record, spread);
        const std::uint32_t level = level_of(hit, record, spread);
        REQUIRE(int(level) == wanted_level(hit, record, spread));
        // Moving a number from one to the other does not change the level.
        const std::int32_t scale = std::exchange(hit.scale, 0);
        record.density += scale;
        REQUIRE(level_of(hit, record, spread) == level);
        inside += scale != 0 && level > 0 && level < record.last_level;
    }
    CHECK(inside > 5000);
}

namespace {

/// Four texels at the place (1, 0) of a line, each with its alpha: above left, above right, below left, below
/// right.
Line with_alphas(const std::array<std::uint32_t, 4>& alphas, TexelFormat format) {
    Draw draw{41};
    Line line = random_texels(draw);
    for (int i = 0; i < 4; ++i) set_alpha(line, 1 + i % 2, i / 2, alphas[std::size_t(i)], format);
    return line;
}

/// A line whose alphas lie at a cut-off or next to it.
struct HoleCase {
    std::uint32_t cutoff;
    std::array<std::uint32_t, 4> alphas;   ///< 8 bits, or 1 bit
};
std::vector<HoleCase> hole_cases(TexelFormat format) {
    std::vector<HoleCase> cases;
    for (const std::uint32_t cutoff : {0u, 1u, 127u, 128u, 254u, 255u}) {
        if (format == TexelFormat::rgb565) {
            for (std::uint32_t bits = 0; bits < 16; ++bits)
                cases.push_back({cutoff, {bits & 1, bits >> 1 & 1, bits >> 2 & 1, bits >> 3}});
            continue;
        }
        cases.push_back({cutoff, {cutoff, cutoff, cutoff, cutoff}});
        cases.push_back({cutoff, {0, 255, 255, 0}});
        for (std::size_t i = 0; i < 4; ++i)
            for (const int by : {-1, 1}) {
                HoleCase made{cutoff, {cutoff, cutoff, cutoff, cutoff}};
                const int beside = int(cutoff) + by, other = int(cutoff) - by;
                if (beside < 0 || beside > 255) continue;
                made.alphas[i] = std::uint32_t(beside);
                cases.push_back(made);
                // One texel below and one above: the heavier one decides.
                if (other < 0 || other > 255) continue;
                made.alphas[(i + 1) % 4] = std::uint32_t(other);
                cases.push_back(made);
            }
    }
    return cases;
}

/// Returns the verdict on a case from its four weights alone.
bool is_hole(const HoleCase& it, int weight_x, int weight_y, TexelFormat format) {
    const int weights[] = {(256 - weight_x) * (256 - weight_y), weight_x * (256 - weight_y),
                           (256 - weight_x) * weight_y, weight_x * weight_y};
    int above = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto alpha = int(format == TexelFormat::rgb888 ? it.alphas[i] : it.alphas[i] * 255);
        above += weights[i] * (alpha - int(it.cutoff));
    }
    return above < 0;
}

}   // namespace

TEST_CASE("a hole is where the filtered alpha is below the cut-off, with all weights", "[tex][hole]") {
    const TexelFormat format = GENERATE(TexelFormat::rgb888, TexelFormat::rgb565);
    for (const HoleCase& it : hole_cases(format)) {
        const Line line = with_alphas(it.alphas, format);
        int holes = 0;
        for (int weight_x = 0; weight_x < 256; ++weight_x)
            for (int weight_y = 0; weight_y < 256; ++weight_y) {
                const TexelPlace place{.x = 1,
                                       .weight_x = std::uint32_t(weight_x),
                                       .weight_y = std::uint32_t(weight_y),
                                       .cutoff = it.cutoff};
                const bool wanted = is_hole(it, weight_x, weight_y, format);
                if ((filter_texels(line, place, format).hole != 0) != wanted)
                    FAIL("cut-off " << it.cutoff << ", weights " << weight_x << " and " << weight_y);
                holes += wanted;
            }
        CAPTURE(it.cutoff, it.alphas);
        if (it.cutoff == 0) CHECK(holes == 0);
        if (it.alphas == std::array<std::uint32_t, 4>{}) CHECK(holes == (it.cutoff > 0 ? 65536 : 0));
    }
}

TEMPLATE_TEST_CASE("tex answers with a hole where alpha is below the cut-off", "[tex][hole][rtl]", TexModel,
                   TexRtl) {
    const Config config = tex_config(GENERATE("rgb888", "rgb565"));
    const Frame frame = tex_frame(0);
    TestType dut{config, frame};
    Draw draw{43};
    int holes = 0, checked = 0;
    // Answers a request for each context in turn: all records, then all texels.
    std::vector<std::pair<int, int>> weights(std::size_t(config.contexts));
    for (const HoleCase& it : hole_cases(config.texels)) {
        const Line line = with_alphas(it.alphas, config.texels);
        // Weights at an end, or just beside it, decide most cases.
        for (auto& [x, y] : weights) x = int(draw.natural(texel_frac)), y = int(draw.natural(texel_frac));
        std::size_t asked = 0, records = 0, texels = 0, answered = 0;
        std::vector<TexelRsp> pending;
        for (int cycle = 0; answered < weights.size(); ++cycle) {
            REQUIRE(cycle < 10 * config.contexts + 100);
            dut.req.offer.reset(), dut.texel_rsp.offer.reset();
            if (asked < weights.size()) dut.req.offer = TexReq{.ray = std::uint32_t(asked), .record = 5};
            if (!pending.empty()) dut.texel_rsp.offer = pending.front();
            dut.texel_req.ready = true;
            dut.eval();
            if (dut.rsp) {
                const auto [x, y] = weights[dut.rsp->ray];
                const bool wanted = is_hole(it, x, y, config.texels);
                CAPTURE(it.cutoff, it.alphas, x, y);
                REQUIRE((dut.rsp->hole != 0) == wanted);
                holes += wanted, ++checked, ++answered;
            }
            if (dut.texel_rsp.fires()) pending.erase(pending.begin());
            if (dut.texel_req.fires()) {
                const std::uint32_t ray = dut.texel_req.offer->ray;
                TexelRsp answer{ray, line};
                if (dut.req.fires()) {
                    // 4 x 4 texels in one level. The filter's first texel is (1, 0).
                    const auto [x, y] = weights[ray];
                    const std::int32_t s = (256 + 128 + x) << 10, t = (128 + y) << 10;
                    TexRecord record{.s = {s, s, s}, .t = {t, t, t}, .log_width = 2, .log_height = 2};
                    record.wrap_s = record.wrap_t = WrapMode::clamp;
                    record.cutoff = it.cutoff;
                    answer.line = {};
                    std::ranges::copy(pack(record, config), answer.line.begin());
                    ++asked, ++records;
                } else {
                    ++texels;
                }
                pending.push_back(answer);
            }
            dut.commit();
        }
        REQUIRE((records == weights.size() && texels == weights.size()));
    }
    CHECK((holes > checked / 10 && holes < checked * 9 / 10));
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
