// raygen: compares camera rays and reciprocal directions with exact fractions.
#include "tests/support/oracle/fractions.hpp"
#include "tests/support/world/traffic.hpp"

namespace rayclock::test::raygen_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Returns a camera whose directions all fit: random ones, and ones at the corners of the format.
Frame camera(unsigned number, const Config& config) {
    Draw draw{number};
    const int g = config.guard_dir_bits();
    Frame frame;
    frame.eye = draw.vector(config.coord_bits);
    const std::int64_t one = std::int64_t(1) << guard_bits, half = one / 2;
    for (std::size_t k = 0; k < 3; ++k) {
        switch ((number + unsigned(k)) % 5) {
            case 0:   // any value
                frame.corner[k] = draw.number(g - 1);
                frame.right[k] = draw.number(g - 2 - max_pixel_bits);
                frame.down[k] = draw.number(g - 2 - max_pixel_bits);
                break;
            case 1:   // through zero in whole steps
                frame.corner[k] = -100 * one;
                frame.right[k] = config.dir_bits > 15 ? one : 0;
                break;
            case 2:   // halves, which are rounded up
                frame.corner[k] = -50 * one + half;
                frame.right[k] = half / 8;
                frame.down[k] = config.dir_bits > 13 ? -half / 2 : 0;
                break;
            case 3:   // longest to the left
                frame.corner[k] = -(std::int64_t(1) << (g - 1)) - (draw.coin() ? 0 : -1);
                break;
            default:   // longest to the right
                frame.corner[k] = (std::int64_t(1) << (g - 1)) - half - 1;
                break;
        }
    }
    return frame;
}

/// Returns a camera with sums of at most g - 1 - `free` bits on every axis. One axis is near the longest of
/// them, on both sides, so that rounding may need one more bit. The others are arbitrary.
Frame short_camera(int free, unsigned seed, const Config& config) {
    Draw draw{seed};
    const int bits = config.guard_dir_bits() - 1 - free;
    const std::int64_t end = std::int64_t(1) << bits;
    Frame frame;
    for (std::size_t k = 0; k < 3; ++k) {
        frame.corner[k] = draw.number(bits);
        if (k == seed % 3) frame.corner[k] = draw.coin() ? end - 1 - draw.below(3) : draw.below(3) - end;
    }
    return frame;
}

Slot random_slot(Draw& draw, const Config& config) {
    Slot slot = random_payload<Slot>(draw, config);
    if (draw.coin()) slot.x = std::uint32_t(draw.below(300));
    if (draw.coin()) slot.y = std::uint32_t(draw.below(300));
    return slot;
}

void judge(const Slot& slot, const Ray& ray, const Frame& frame, const Config& config) {
    CAPTURE(slot.x, slot.y);
    REQUIRE(ray.ray == slot.ray);
    REQUIRE(ray.o == frame.eye);
    std::array<oracle::Rational, 3> exact;
    for (std::size_t k = 0; k < 3; ++k) {
        const oracle::Int sum = oracle::Int(frame.corner[k]) + oracle::Int(slot.x) * frame.right[k] +
                                oracle::Int(slot.y) * frame.down[k];
        exact[k] = oracle::Rational(sum, oracle::Int(1) << guard_bits);
    }
    const std::array<oracle::Int, 3> direction = oracle::filled(exact, config.dir_bits, max_shift);
    for (std::size_t k = 0; k < 3; ++k) {
        // With two levels the least number, which has no opposite, becomes one more.
        const oracle::Int least = config.has_instances() - (oracle::Int(1) << (config.dir_bits - 1)),
                          d = std::max(direction[k], least);
        CAPTURE(k, d);
        REQUIRE(ray.d[k] == d);
        REQUIRE(ray.len[k] == std::uint32_t(oracle::digits(d)));
        if (d == 0) {
            REQUIRE(ray.recip[k] == 1);
            continue;
        }
        const oracle::Rational inverse = oracle::scaled_reciprocal(d, config.recip_bits);
        REQUIRE(ray.recip[k] <= inverse);
        REQUIRE(inverse < oracle::Int(ray.recip[k]) + 1);
    }
}

template <class Dut> void against_oracle(const char* name, unsigned seed, const Pace& pace, int count) {
    const Config config = format(name);
    INFO(name << ", seed " << seed);
    const Frame frame = camera(seed, config);
    Draw draw{seed};
    Dut dut{config, frame, int(seed)};
    stream(
        dut, config, pace, draw, count, [&](Draw& from) { return random_slot(from, config); },
        [&](const Slot& slot, const Ray& ray) { judge(slot, ray, frame, config); });
}

void shared_moves(const Config& config) {
    for (const Pace& pace : paces)
        for (unsigned seed = 11; seed <= 13; ++seed)
            check_lockstep<RaygenUnit>(config, camera(seed, config), pace, seed,
                                       1500 * config.raygen_interval,
                                       [&](Draw& draw) { return random_slot(draw, config); });
}

}   // namespace

TEMPLATE_TEST_CASE("raygen gives the rounded direction and a bracket of its reciprocal", "[raygen]",
                   Model<RaygenUnit>, Rtl<RaygenUnit>) {
    const auto name = GENERATE("default", "small", "narrow", "wide", "sheared:default", "rays8:fast:default");
    for (unsigned seed = 1; seed <= 10; ++seed) against_oracle<TestType>(name, seed, paces[seed % 4], 250);
}

TEMPLATE_TEST_CASE("a camera ray of two levels has an opposite", "[raygen]", Model<RaygenUnit>,
                   Rtl<RaygenUnit>) {
    Config config = format(GENERATE("default", "fast:narrow"));
    config.levels = 2;
    int longest = 0;
    for (unsigned seed = 1; seed <= 24; ++seed) {
        INFO(config.name << ", seed " << seed);
        const Frame frame = short_camera(int(seed % 3), seed, config);
        Draw draw{seed};
        TestType dut{config, frame, int(seed)};
        const auto make_slot = [&](Draw& from) { return random_slot(from, config); };
        stream(dut, config, paces[0], draw, 4, make_slot, [&](const Slot& slot, const Ray& ray) {
            judge(slot, ray, frame, config);
            for (const std::int32_t d : ray.d) longest += d == 1 - (1 << (config.dir_bits - 1));
        });
    }
    REQUIRE(longest > 0);
}

TEST_CASE("a reciprocal brackets the exact one for every direction of 12 bits", "[raygen]") {
    Config config;
    config.dir_bits = 12;
    config.recip_bits = GENERATE(8, 9, 16, 24);
    for (std::int32_t d = -2048; d < 2048; ++d) {
        if (d == 0) continue;
        const Recip r = reciprocal(d, config);
        const oracle::Rational exact = oracle::scaled_reciprocal(d, config.recip_bits);
        CAPTURE(d);
        REQUIRE(r.len == std::uint32_t(oracle::digits(d)));
        REQUIRE((r.recip <= exact && exact < oracle::Int(r.recip) + 1));
    }
}

TEMPLATE_TEST_CASE("raygen fills the bits of a direction, however short the sum is", "[raygen][long]",
                   Model<RaygenUnit>, Rtl<RaygenUnit>) {
    const Config config = format(GENERATE("default", "narrow", "wide"));
    for (int free = 0; free <= max_shift + 2; ++free)
        for (unsigned seed = 1; seed <= 12; ++seed) {
            INFO(config.name << ", " << free << " bits free, seed " << seed);
            const Frame frame = short_camera(free, seed, config);
            Draw draw{seed};
            TestType dut{config, frame, int(seed)};
            const auto make_slot = [&](Draw& from) { return random_slot(from, config); };
            stream(dut, config, paces[0], draw, 4, make_slot, [&](const Slot& slot, const Ray& ray) {
                judge(slot, ray, frame, config);
                const auto [x, y, z] = ray.d;
                if (free <= max_shift)
                    REQUIRE(std::max({std::abs(x), std::abs(y), std::abs(z)}) >= 1 << (config.dir_bits - 2));
            });
        }
}

TEMPLATE_TEST_CASE("raygen answers after exactly its latency", "[raygen][long]", Model<RaygenUnit>,
                   Rtl<RaygenUnit>) {
    const Config config = format(GENERATE("default", "narrow", "wide", "sheared:default", "fast:default",
                                          "fast:narrow", "rays2:default", "rays8:fast:default"));
    TestType dut{config, camera(5, config)};
    check_latency(dut, config, [&](Draw& draw) { return random_slot(draw, config); });
}

TEMPLATE_TEST_CASE("raygen makes a ray in every cycle", "[raygen]", Model<RaygenUnit>, Rtl<RaygenUnit>) {
    const Config config = format(GENERATE("default", "wide", "sheared:default", "fast:default"));
    TestType dut{config, camera(5, config)};
    check_throughput(dut, config, [&](Draw& draw) { return random_slot(draw, config); });
}

TEST_CASE("model and RTL of raygen make the same moves in every cycle", "[raygen][lockstep]") {
    const Config config = format(GENERATE("default", "small", "narrow", "wide"));
    for (const Pace& pace : paces)
        for (unsigned seed = 11; seed <= 15; ++seed)
            check_lockstep<RaygenUnit>(config, camera(seed, config), pace, seed, 1500,
                                       [&](Draw& draw) { return random_slot(draw, config); });
}

TEST_CASE("model and RTL of a fast raygen make the same moves in every cycle",
          "[raygen][lockstep][fast][long]") {
    const Config config = format(GENERATE("fast:default", "fast:small", "fast:narrow", "fast:wide",
                                          "fast:sheared:default", "fast:sheared:precise"));
    for (const Pace& pace : paces)
        for (unsigned seed = 11; seed <= 13; ++seed)
            check_lockstep<RaygenUnit>(config, camera(seed, config), pace, seed, 1500,
                                       [&](Draw& draw) { return random_slot(draw, config); });
}

TEMPLATE_TEST_CASE("raygen that shares steps of its divisions makes a ray every few cycles",
                   "[raygen][interval][long]", Model<RaygenUnit>, Rtl<RaygenUnit>) {
    const Config config = format(GENERATE("rays2:default", "rays8:fast:default"));
    TestType dut{config, camera(5, config)};
    check_throughput(dut, config, [&](Draw& draw) { return random_slot(draw, config); });
}

TEST_CASE("model and RTL of a raygen that shares steps make the same moves in every cycle",
          "[raygen][lockstep][interval][long]") {
    shared_moves(format(GENERATE("rays2:default", "rays8:fast:narrow", "rays4:sheared:default")));
}

TEST_CASE("model and RTL of a raygen that shares steps make the same moves, other formats",
          "[raygen][lockstep][interval][slow]") {
    shared_moves(
        format(GENERATE("rays4:default", "rays8:default", "rays2:fast:small", "rays4:fast:small",
                        "rays8:fast:small", "rays4:wide", "rays8:fast:wide", "rays8:fast:sheared:precise")));
}

TEST_CASE("model and RTL of raygen with slopes make the same moves in every cycle",
          "[raygen][lockstep][sheared][long]") {
    const Config config = format(GENERATE("sheared:default", "sheared:narrow", "sheared:precise"));
    check_lockstep<RaygenUnit>(config, Frame{}, paces[0], 1, 100,
                               [&](Draw& draw) { return random_slot(draw, config); });   // d = 0
    for (const Pace& pace : paces)
        for (unsigned seed = 11; seed <= 15; ++seed)
            check_lockstep<RaygenUnit>(config, camera(seed, config), pace, seed, 1500,
                                       [&](Draw& draw) { return random_slot(draw, config); });
}

}   // namespace rayclock::test::raygen_test
