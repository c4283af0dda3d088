// shade: contexts between the answer to their ray and their next ray or pixel.
#include <deque>

#include <catch2/catch.hpp>

#include "tests/support/dut/shade_dut.hpp"
#include "tests/support/world/traffic.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

Config shape(const std::string& format, int contexts, int queue) {
    Config c = shaded_format(format);
    c.contexts = contexts, c.shade_queue = queue;
    return c;
}

void same_in_every_cycle(const Config& c, int idle, int stall, unsigned seed, int cycles, ShadeWorld& world,
                         const Frame& frame) {
    ShadeModel model(c, frame);
    ShadeRtl rtl(c, frame, int(seed));
    for (int i = 0; i < cycles; ++i) {
        INFO(c.name << ", " << c.contexts << " contexts, idle " << idle << ", stall " << stall << ", seed "
                    << seed << ", cycle " << i);
        world.offer(model);
        static_cast<ShadeLinks&>(rtl) = model;
        model.eval();
        rtl.eval();
        REQUIRE(rtl.cause == model.cause);
        REQUIRE(same(rtl.closest, model.closest, c));
        REQUIRE(same(rtl.surf_req, model.surf_req, c));
        REQUIRE(same(rtl.surf_rsp, model.surf_rsp, c));
        REQUIRE(same(rtl.tex_req, model.tex_req, c));
        REQUIRE(same(rtl.spawn, model.spawn, c));
        if (rtl.pixel.offer && model.pixel.offer) {
            const Pixel &got = *rtl.pixel.offer, &wanted = *model.pixel.offer;
            CAPTURE(got.colour, wanted.colour, got.first.ray, wanted.first.ray, got.first.found,
                    wanted.first.found, got.first.t, wanted.first.t);
            REQUIRE(same(got, wanted, c));
        }
        REQUIRE(same(rtl.pixel, model.pixel, c));
        world.take_over(model);
        model.commit();
        rtl.commit();
    }
}

void check(const char* format, int contexts, int queue, int cycles) {
    const Config c = shape(format, contexts, queue);
    int pixels = 0, shadows = 0, bounces = 0, samples = 0, closed = 0, textures = 0, cutouts = 0;
    unsigned seed = 1;
    for (const auto& [name, idle, stall] : paces) {
        Draw draw{seed};
        Frame frame = random_shade_frame(draw, c);
        frame.shade.first_surface_line = std::uint32_t(draw.bits(c.addr_bits));
        frame.shade.depth = std::uint32_t(draw.between(1, c.bounces));
        frame.shade.threshold = 0;
        frame.shade.side = c.supersampling ? seed : 1;
        ShadeWorld world(c, frame, idle, stall, seed);
        same_in_every_cycle(c, idle, stall, seed++, cycles, world, frame);
        pixels += world.pixels, shadows += world.shadows, bounces += world.bounces, samples += world.samples,
            closed += world.closed, textures += world.textures, cutouts += world.cutouts;
    }
    CAPTURE(pixels, shadows, bounces, samples, closed);
    REQUIRE((pixels > 10 && shadows > 10 && bounces > 10));
    REQUIRE((samples > 0) == (c.supersampling));
    REQUIRE((closed > 0) == (queue < 32 && queue < contexts));
    REQUIRE((textures > 10) == c.has_textures());
    REQUIRE((cutouts > 10) == c.has_textures());
}

template <class Dut> void still(Dut& dut) {
    dut.slot.reset(), dut.ray.reset(), dut.closest.offer.reset(), dut.surf_rsp.offer.reset();
    dut.surf_req.ready = dut.tex_req.ready = dut.spawn.ready = dut.pixel.ready = true;
}
template <class Dut> void step(Dut& dut) {
    dut.eval();
    dut.commit();
    still(dut);
}

}   // namespace

TEST_CASE("model and RTL of shade make the same moves in every cycle", "[shade][lockstep][all]") {
    check("all", 64, 64, 3000);
}

TEST_CASE(
    "model and RTL of shade make the same moves with a short queue, and without units that are not needed",
    "[shade][lockstep]") {
    check("all", 8, 4, 3000);
    check("plain", 64, 64, 3000);
}

TEST_CASE("model and RTL of shade make the same moves with a pass every few cycles",
          "[shade][lockstep][interval][long]") {
    check("every4:all", 64, 8, 6000);
    check("every4:plain", 64, 64, 6000);
    check("every4:plain", 64, 8, 3000);
    check("every8:fast:all", 64, 64, 6000);
}

TEST_CASE("model and RTL of shade make the same moves with textures", "[shade][lockstep][textures][long]") {
    check("textured:all", 64, 64, 3000);
    check("textured:all", 8, 4, 3000);
    check("textured:every4:fast:plain", 64, 8, 6000);
}

TEST_CASE("model and RTL of shade make the same moves in every cycle, for long", "[shade][lockstep][slow]") {
    const auto format = GENERATE("all", "plain", "mirror", "narrow", "broad", "short", "every8:fast:all",
                                 "every4:all", "every2:plain");
    check(format, 64, 64, 40000);
    check(format, 32, 8, 40000);
    check(format, 1, 2, 40000);
}

// The ray hits only textured triangles. Each has a hole at the hit.
TEMPLATE_TEST_CASE("a ray goes through 63 holes, and the next texture is drawn", "[shade][hole]", ShadeModel,
                   ShadeRtl) {
    const Config c = shape("textured:all", 64, 64);
    Frame frame;
    frame.shade.side = 1, frame.shade.depth = 0;
    frame.shade.share = 1 << unit_bits;
    TestType dut(c, frame);
    still(dut);
    // Runs until a link fires, and returns its payload.
    const auto next = [&](auto& link) {
        for (int i = 0; i < 400; ++i) {
            dut.eval();
            const auto offer = link.offer;
            dut.commit();
            still(dut);
            if (offer) return *offer;
        }
        FAIL("no link fires");
        return *link.offer;
    };
    dut.slot = Slot{5, 7, 9};
    step(dut);
    Ray ray;
    ray.ray = 5, ray.o = {100, -200, 300}, ray.d = {70, 80, 90};
    const int holes = 63;
    for (int i = 0; i <= holes; ++i) {
        INFO("hole " << i);
        dut.ray = ray;
        step(dut);
        const Closest hit{5, 1, std::uint32_t(i), std::uint32_t(1000 + i), 1u << (c.bary_bits - 2), 0, 0};
        dut.closest.offer = hit;
        step(dut);
        REQUIRE(next(dut.surf_req).ray == 5);
        Surface surface;
        surface.record = 77;
        surface.a = {10, 20, i}, surface.b = {14, 20, i}, surface.c = {10, 24, i};
        surface.colour = {4096, 4096, 4096}, surface.ambient = 4096;
        dut.surf_rsp.offer = SurfRsp{5, surface};
        dut.eval();
        while (!dut.surf_rsp.ready) step(dut), dut.surf_rsp.offer = SurfRsp{5, surface}, dut.eval();
        dut.commit();
        still(dut);
        const TexReq request = next(dut.tex_req);
        REQUIRE((request.ray == 5 && request.record == 77));
        dut.tex_rsp = TexRsp{5, 1, {4096, 2048, 0}};
        step(dut);
        dut.tex_rsp.reset();
        if (i == holes) break;
        const Spawn goes_on = next(dut.spawn);
        REQUIRE(goes_on.kind == RayKind::bounce);
        REQUIRE(goes_on.d == ray.d);
        // At a quarter of the first edge, at most 1/256 of a step inwards.
        for (std::size_t k = 0; const int at : {11, 20, i}) {
            const std::int32_t beside = goes_on.o[k++] - (at << c.origin_bits);
            REQUIRE((beside >= 0 && beside <= 1 << (c.origin_bits - 8)));
        }
        ray.kind = goes_on.kind, ray.o = goes_on.o;
    }
    const Pixel pixel = next(dut.pixel);
    REQUIRE((pixel.first.found == 1 && pixel.first.prim == 0 && pixel.first.t == 1000));
    REQUIRE(pixel.colour == std::array<std::uint32_t, 3>{1 << 16, 1 << 15, 0});
}

// A camera ray that hits nothing has two passes: for its background, and for the end of the sample.
TEMPLATE_TEST_CASE("shade answers after exactly its latency", "[shade]", ShadeModel, ShadeRtl) {
    const Config c = shape(GENERATE("plain", "every4:plain"), 64, 64);
    Frame frame;
    frame.shade.background = {0x8000, 1, 0x10000};
    frame.shade.side = 1;
    TestType dut(c, frame);
    still(dut);
    dut.slot = Slot{5, 7, 9};
    step(dut);
    Ray ray;
    ray.ray = 5, ray.d = {0, 0, 1};
    dut.ray = ray;
    step(dut);
    dut.closest.offer = Closest{5, 0, 0, 0, 0, 0, 0};
    step(dut);
    const int due = 2 * (c.shade_latency() + 2) + 1;
    for (int i = 1; i <= due; ++i) {
        dut.eval();
        CAPTURE(i);
        REQUIRE(dut.pixel.offer.has_value() == (i == due));
        REQUIRE_FALSE(dut.spawn.offer);
        if (i == due)
            REQUIRE((dut.pixel.offer->first.ray == 5 && dut.pixel.offer->colour == frame.shade.background));
        dut.commit();
        still(dut);
    }
}

TEMPLATE_TEST_CASE("shade does a pass in every cycle, or every few", "[shade]", ShadeModel, ShadeRtl) {
    const Config c = shape(GENERATE("plain", "every4:plain"), 64, 64);
    const int every = c.shade_interval;
    Frame frame;
    frame.shade.side = 1;
    TestType dut(c, frame);
    still(dut);
    for (std::uint32_t i = 0; i < 64; ++i) {
        dut.slot = Slot{i, i, i};
        step(dut);
        dut.ray = Ray{};
        dut.ray->ray = i;
        step(dut);
    }
    // `first`: the first cycle with a pass. `idle`: the first later cycle without one.
    int first = -1, idle = -1, busy = 0, pixels = 0;
    for (int i = 0; i < 400 * every; ++i) {
        if (i < 64) dut.closest.offer = Closest{std::uint32_t(i), 0, 0, 0, 0, 0, 0};
        dut.eval();
        if (dut.cause == 0) {
            first = first < 0 ? i : first;
            ++busy;
        } else if (first >= 0 && idle < 0) {
            idle = i;
        }
        pixels += dut.pixel.fires();
        dut.commit();
        still(dut);
    }
    REQUIRE(pixels == 64);
    REQUIRE(busy == 128 * every);
    // Then the last few wait for the end of their first pass: four with one cycle per pass, six with four.
    REQUIRE((first == 1 && idle == (every == 1 ? 125 : 1 + 122 * 4)));
}
