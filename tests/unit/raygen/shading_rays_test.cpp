// raygen of a shading chip: rays of every kind, samples of a pixel, and the priority of requests.
#include "model/compile/frame.hpp"
#include "model/layout/memory_image.hpp"
#include "tests/support/oracle/fractions.hpp"
#include "model/scene/whitted.hpp"
#include "tests/support/dut/raygen_dut.hpp"
#include "tests/support/world/traffic.hpp"

namespace rayclock::test::shading_rays_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Returns a frame with cameras of every angle, lattices of every pitch, and n x n samples.
Frame frame_of(unsigned seed, const Config& config, int n, bool jitter) {
    Draw draw{seed};
    Camera camera{{3, 4, 5}, {-1, 0.5, 0.25}, {0.1, 1, 0.2}, std::array{1.0, 45.0, 120.0, 179.0}[seed % 4]};
    Lattice lattice;
    lattice.pitch = {0.01, 0.02, 0.015};
    const int side = 1 << draw.between(1, 12);
    Frame frame = make_frame(camera, seed % 5 == 0 ? FrameSize{1, 1} : FrameSize{side + draw.below(3), side},
                             lattice, config);
    frame.eye = draw.vector(config.coord_bits);
    frame.shade.side = std::uint32_t(n);
    frame.shade.stride = sample_stride(n);
    frame.shade.jitter = jitter;
    frame.shade.seed = std::uint32_t(draw.bits(32));
    return frame;
}

Spawn random_spawn(Draw& draw, const Frame& frame, const Config& config) {
    Spawn spawn = random_payload<Spawn>(draw, config);
    spawn.x = std::uint32_t(draw.below(int(frame.width)));
    spawn.y = std::uint32_t(draw.below(int(frame.height)));
    if (draw.below(8) == 0) spawn.x = draw.coin() ? 0 : frame.width - 1;
    if (draw.below(8) == 0) spawn.y = draw.coin() ? 0 : frame.height - 1;
    spawn.sample = std::uint32_t(draw.below(int(frame.shade.side * frame.shade.side)));
    const auto kind = spawn.kind;
    if (kind == RayKind::bounce || kind == RayKind::away) spawn.d = draw.vector(config.dir_bits);
    return spawn;
}

/// The hash in 64 bits, truncated after every step.
std::uint64_t jenkins(std::uint64_t seed, std::initializer_list<std::uint64_t> words) {
    constexpr std::uint64_t word = 0xffffffff;
    std::uint64_t h = seed;
    for (const std::uint64_t w : words) {
        h = (h + w) & word;
        h = (h * 1025) & word;
        h ^= h / 64;
    }
    h = (h * 9) & word;
    h ^= h / 2048;
    return (h * 32769) & word;
}

/// Returns the point of the picture in pixels, from cell and place in it, as fractions.
std::array<oracle::Rational, 2> place_of(const Spawn& spawn, const Frame& frame, const Config& config) {
    const ShadeFrame& s = frame.shade;
    std::array<oracle::Rational, 2> at{oracle::Rational(spawn.x), oracle::Rational(spawn.y)};
    if (!config.supersampling) return at;
    const std::uint64_t cell = std::uint64_t(spawn.sample) * s.stride % (s.side * s.side);
    const std::uint64_t random = jenkins(s.seed, {spawn.x, spawn.y, spawn.sample}),
                        cells[] = {cell % s.side, cell / s.side};
    for (std::size_t k = 0; k < 2; ++k) {
        const std::uint64_t place = s.jitter ? random >> 8 * k & 255 : 128;
        const oracle::Rational exact =
            // Position in the pixel, from its corner.
            (oracle::Rational(cells[k]) + oracle::Rational(place, 256)) / s.side;
        at[k] += oracle::Rational(oracle::floor(exact * 256), 256) - oracle::Rational(1, 2);
    }
    return at;
}

void judge(const Spawn& spawn, const Ray& ray, const Frame& frame, const Config& config) {
    CAPTURE(int(spawn.kind), spawn.x, spawn.y, spawn.sample);
    REQUIRE((ray.ray == spawn.ray && ray.kind == spawn.kind));
    REQUIRE((ray.self == spawn.self && ray.is_inside == spawn.is_inside));
    const bool camera = spawn.kind == RayKind::camera, shadow = spawn.kind == RayKind::shadow;
    const auto at = place_of(spawn, frame, config);
    std::array<oracle::Rational, 3> sum;
    for (std::size_t k = 0; k < 3; ++k)
        sum[k] = (frame.corner[k] + at[0] * frame.right[k] + at[1] * frame.down[k]) /
                 oracle::power_of_two(guard_bits);
    const std::array<oracle::Int, 3> direction = oracle::filled(sum, config.dir_bits, max_shift);
    if (camera) REQUIRE(oracle::longest(direction) >= oracle::Int(1) << (config.dir_bits - 2));
    for (std::size_t k = 0; k < 3; ++k) {
        CAPTURE(k);
        oracle::Int d = spawn.d[k], o = spawn.o[k];
        if (camera) {
            d = direction[k];
            o = oracle::Int(frame.eye[k]) << config.origin_bits;
        }
        REQUIRE(ray.d[k] == d);
        REQUIRE(ray.o[k] == o);
        REQUIRE(oracle::digits(d) <= config.ray_dir_bits());
        if (camera)
            REQUIRE((-d <= oracle::Int(1) << (config.dir_bits - 1) && d < oracle::Int(1)
                                                                              << (config.dir_bits - 1)));
        if (d == 0) {
            REQUIRE((ray.recip[k] == 1 && ray.len[k] == 0));
            continue;
        }
        // As long as a shadow ray's: 2^(N + B) replaces the 2^(M - 1) of the others.
        REQUIRE(int(ray.len[k]) ==
                oracle::digits(d) +
                    (shadow ? 0 : config.coord_bits + config.origin_bits + 1 - config.dir_bits));
        const oracle::Rational exact = oracle::scaled_reciprocal(d, config.recip_bits);
        REQUIRE((ray.recip[k] <= exact && exact < oracle::Int(ray.recip[k]) + 1));
    }
}

/// Sends rays of shade and new pixels, each in order. A new pixel is the first sample's camera ray.
template <class Dut>
void make_rays(const Config& config, const Frame& frame, unsigned seed, const Pace& pace, int count) {
    INFO(config.name << ", " << pace.name << ", seed " << seed << ", " << frame.shade.side
                     << " samples a side");
    Dut dut{frame, config, int(seed)};
    Draw draw{seed};
    Steady<Ray> steady{config};
    std::deque<Spawn> waiting;
    int made = 0, pixels = 0;
    for (int cycle = 0; made < count; ++cycle) {
        REQUIRE(cycle < 20 * count + 1000);
        if (!dut.spawn.offer && draw.percent(70) && !draw.percent(pace.idle_percent))
            dut.spawn.offer = random_spawn(draw, frame, config);
        if (!dut.slot.offer && draw.percent(40)) {
            const Spawn pixel = random_spawn(draw, frame, config);
            dut.slot.offer = Slot{pixel.ray, pixel.x, pixel.y};
        }
        dut.ray.ready = !draw.percent(pace.stall_percent);
        dut.eval();
        steady.check(dut.ray);
        REQUIRE_FALSE((dut.spawn.fires() && dut.slot.fires()));
        if (dut.ray.fires()) {
            REQUIRE_FALSE(waiting.empty());
            judge(waiting.front(), *dut.ray.offer, frame, config);
            waiting.pop_front();
            ++made;
        }
        const bool spawned = dut.spawn.fires(), given = dut.slot.fires();
        if (spawned) waiting.push_back(*dut.spawn.offer);
        if (given) {
            Spawn pixel;
            pixel.ray = dut.slot.offer->ray, pixel.x = dut.slot.offer->x, pixel.y = dut.slot.offer->y;
            waiting.push_back(pixel);
            ++pixels;
        }
        dut.commit();
        if (spawned) dut.spawn.offer.reset();
        if (given) dut.slot.offer.reset();
    }
    REQUIRE(pixels > count / 20);
}

void same_moves(const Config& config) {
    for (const Pace& pace : paces)
        for (unsigned seed = 11; seed <= 13; ++seed) {
            const Frame frame =
                frame_of(seed, config, config.supersampling ? int(seed % 8) + 1 : 1, seed % 2 == 0);
            RaygenModel model{frame, config};
            RaygenRtl rtl{frame, config, int(seed)};
            Draw draw{seed};
            int made = 0;
            for (int cycle = 0; cycle < 1500; ++cycle) {
                INFO(config.name << ", " << pace.name << ", seed " << seed << ", cycle " << cycle);
                if (!model.spawn.offer && draw.coin() && !draw.percent(pace.idle_percent))
                    model.spawn.offer = random_spawn(draw, frame, config);
                if (!model.slot.offer && draw.coin()) {
                    const Spawn pixel = random_spawn(draw, frame, config);
                    model.slot.offer = Slot{pixel.ray, pixel.x, pixel.y};
                }
                model.ray.ready = !draw.percent(pace.stall_percent);
                static_cast<RaygenLinks&>(rtl) = model;
                model.eval();
                rtl.eval();
                REQUIRE(same(model.spawn, rtl.spawn, config));
                REQUIRE(same(model.slot, rtl.slot, config));
                REQUIRE(same(model.ray, rtl.ray, config));
                const bool spawned = model.spawn.fires(), given = model.slot.fires();
                made += model.ray.fires();
                model.commit();
                rtl.commit();
                if (spawned) model.spawn.offer.reset();
                if (given) model.slot.offer.reset();
            }
            REQUIRE(made > 300 / config.raygen_interval);
        }
}

template <class Dut> void rays_of_every_kind(const Config& config) {
    for (unsigned seed = 1; seed <= 5; ++seed)
        make_rays<Dut>(config, frame_of(seed, config, 1, false), seed, paces[seed % 4], 400);
}

template <class Dut> void every_sample(const Config& config) {
    for (int n = 1; n <= max_aa; ++n)
        for (const bool jitter : {false, true})
            make_rays<Dut>(config, frame_of(unsigned(n), config, n, jitter), unsigned(2 * n + jitter),
                           paces[std::size_t(n % 4)], 300);
}

}   // namespace

TEMPLATE_TEST_CASE("raygen makes rays of every kind with a bracket of the reciprocal", "[raygen][shading]",
                   RaygenModel, RaygenRtl) {
    rays_of_every_kind<TestType>(format(GENERATE("shading:default", "shading:narrow")));
}
TEMPLATE_TEST_CASE("raygen makes rays of every kind, other formats", "[raygen][shading][slow]", RaygenModel,
                   RaygenRtl) {
    rays_of_every_kind<TestType>(format(GENERATE("shading:small", "shading:wide")));
}

TEMPLATE_TEST_CASE("raygen sends camera rays through every sample of a pixel", "[raygen][shading]",
                   RaygenModel, RaygenRtl) {
    every_sample<TestType>(format("samples:default"));
}
TEMPLATE_TEST_CASE("raygen sends camera rays through every sample, other formats", "[raygen][shading][slow]",
                   RaygenModel, RaygenRtl) {
    every_sample<TestType>(format(GENERATE("samples:small", "samples:wide")));
}

TEMPLATE_TEST_CASE("raygen accepts shade's ray before a new pixel, and one ray in every cycle",
                   "[raygen][shading]", RaygenModel, RaygenRtl) {
    Config config = format(GENERATE("shading:default", "samples:default"));
    if (config.supersampling) config.raygen_queue = 32;   // more than its latency
    const Frame frame = frame_of(3, config, config.supersampling ? 4 : 1, true);
    TestType dut{frame, config};
    Draw draw{7};
    dut.ray.ready = true;
    int first = -1;
    for (int cycle = 0; cycle < 100; ++cycle) {
        dut.spawn.offer.reset();
        if (cycle % 3 != 2) dut.spawn.offer = random_spawn(draw, frame, config);
        dut.slot.offer = Slot{1, 2, 3};
        dut.eval();
        REQUIRE(dut.spawn.fires() == (cycle % 3 != 2));
        REQUIRE(dut.slot.fires() == (cycle % 3 == 2));
        if (first < 0 && dut.ray.offer) first = cycle;
        REQUIRE((first >= 0) == dut.ray.offer.has_value());
        dut.commit();
    }
    REQUIRE(first == config.raygen_latency() + 1);
    // A pixel that was offered and not accepted stays offered, whatever shade requests.
    dut.spawn.offer.reset();
    dut.ray.ready = false;
    for (int cycle = 0; cycle < 2 * config.raygen_queue; ++cycle) dut.eval(), dut.commit();
    dut.spawn.offer = random_spawn(draw, frame, config);
    dut.ray.ready = true;
    dut.eval();
    REQUIRE_FALSE((dut.slot.fires() || dut.spawn.fires()));
    dut.commit();
    dut.eval();
    REQUIRE((dut.slot.fires() && !dut.spawn.ready));
    dut.commit();
    dut.eval();
    REQUIRE(dut.spawn.fires());
}

TEST_CASE("model and RTL of raygen make the same moves in every cycle with rays of shade",
          "[raygen][lockstep][shading]") {
    same_moves(format(GENERATE("shading:default", "samples:default", "rays8:fast:shading:default",
                               "rays4:samples:default")));
}

TEST_CASE("model and RTL of raygen make the same moves with rays of shade, other formats",
          "[raygen][lockstep][shading][slow]") {
    same_moves(format(GENERATE("shading:wide", "samples:narrow")));
}

TEST_CASE("a reciprocal brackets the exact one for the longest directions", "[raygen][shading]") {
    Config config = format("shading:default");
    config.recip_bits = GENERATE(8, 16, 23, 24);
    Draw draw{5};
    for (int i = 0; i < 30000; ++i) {
        // Near the top, and near quotients that are whole: |d| = 2^54 / q.
        std::int32_t d = i % 3 == 0 ? (1 << 30) - 1 - i : std::int32_t(draw.number(31));
        if (i % 3 == 1)
            d = std::int32_t((std::int64_t(1) << 53) / (std::int64_t(1 << 23) + draw.below(1 << 23))) +
                draw.between(-1, 1);
        if (d == 0) continue;
        const Recip r = reciprocal(d, config);
        const oracle::Rational exact = oracle::scaled_reciprocal(d, config.recip_bits);
        CAPTURE(d, config.recip_bits);
        REQUIRE(r.len == std::uint32_t(oracle::digits(d)));
        REQUIRE((r.recip <= exact && exact < oracle::Int(r.recip) + 1));
    }
}

TEST_CASE("without samples a pixel's ray is what it is without shading", "[raygen][shading]") {
    const Config plain = format("default"), config = format("shading:default"),
                 samples = format("samples:default");
    for (unsigned seed = 1; seed <= 8; ++seed) {
        const Frame frame = frame_of(seed, plain, 1, false);
        Draw draw{seed};
        for (int i = 0; i < 500; ++i) {
            const Spawn spawn = random_spawn(draw, frame, plain);
            const Slot slot{spawn.ray, spawn.x, spawn.y};
            const Ray before = raygen(slot, frame, plain), now = raygen(slot, frame, config),
                      sample = raygen(slot, frame, samples);
            REQUIRE((now.d == before.d && sample.d == before.d));
            REQUIRE((now.recip == before.recip && sample.recip == before.recip));
            REQUIRE((now.o == ray_origin(before.o, config) && same(now, sample, samples)));
        }
    }
}

}   // namespace rayclock::test::shading_rays_test
