// sched: the assignment of pixels to contexts, and of hits to pixels.
#include "tests/support/world/sched_world.hpp"

namespace rayclock::test::sched_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

Frame frame_of(int width, int height) {
    Frame frame;
    frame.width = std::uint32_t(width);
    frame.height = std::uint32_t(height);
    return frame;
}

Config tiled(int tile_bits) {
    Config config = format("default");
    config.name = "tiles of 2^" + std::to_string(tile_bits);
    config.tile_bits = tile_bits;
    return config;
}

constexpr std::pair<int, int> sizes[] = {{1, 1}, {1, 9}, {64, 1}, {13, 5}, {40, 17}};

template <class Dut>
void give_pixels(const Config& config, const Frame& frame, unsigned seed, const Pace& pace) {
    INFO(config.name << ", " << config.contexts << " contexts, " << frame.width << " x " << frame.height
                     << ", " << pace.name << ", seed " << seed);
    Dut dut{frame, config, int(seed)};
    SchedWorld world{frame, config, seed, pace};
    for (int cycle = 0; !world.finished(); ++cycle) {
        INFO("cycle " << cycle);
        REQUIRE(cycle < 100000);
        world.drive(dut);
        dut.eval();
        world.watch(dut);
        dut.commit();
    }
    dut.pixel.offer.reset();
    dut.tile.offer.reset();
    for (int i = 0; i < 70; ++i) {
        dut.eval();
        REQUIRE_FALSE(dut.slot.offer);
        dut.commit();
    }
}

void lockstep(const Config& config, const Frame& frame, unsigned seed, const Pace& pace) {
    SchedModel model{frame, config};
    SchedRtl rtl{frame, config, int(seed)};
    SchedWorld world{frame, config, seed, pace};
    for (int cycle = 0; !world.finished(); ++cycle) {
        INFO(config.name << ", " << frame.width << " x " << frame.height << ", " << pace.name << ", seed "
                         << seed << ", cycle " << cycle);
        REQUIRE(cycle < 100000);
        world.drive(model);
        static_cast<SchedLinks&>(rtl) = model;
        model.eval();
        rtl.eval();
        REQUIRE(same(model.tile, rtl.tile, config));
        REQUIRE(same(model.slot, rtl.slot, config));
        REQUIRE(same(model.pixel, rtl.pixel, config));
        REQUIRE(same(model.hit, rtl.hit, config));
        world.watch(rtl);
        model.commit();
        rtl.commit();
    }
}

/// Returns the order of pixels if tiles come on request, row by row, and every ray ends in the next cycle.
template <class Dut> std::vector<PixelCoord> order_of(const Config& config, const Frame& frame) {
    Dut dut{frame, config};
    std::deque<Tile> tiles = tiles_of(frame, config.tile_bits);
    const std::size_t patience = (tiles.size() + 2) << 2 * config.tile_bits;
    dut.slot.ready = dut.hit.ready = true;
    std::vector<PixelCoord> order;
    for (std::size_t cycle = 0; order.size() < std::size_t(frame.width) * frame.height; ++cycle) {
        if (cycle > patience) FAIL("no pixel after " << order.size());
        dut.tile.offer.reset();
        if (!tiles.empty()) dut.tile.offer = tiles.front();
        dut.eval();
        if (dut.tile.fires()) tiles.pop_front();
        const std::optional<Slot> slot = dut.slot.offer;
        dut.commit();
        dut.pixel.offer.reset();
        if (!slot) continue;
        order.push_back({slot->x, slot->y});
        dut.pixel.offer = Pixel{};
        dut.pixel.offer->first.ray = slot->ray;
    }
    return order;
}

}   // namespace

TEMPLATE_TEST_CASE("sched gives a tile's pixels in Morton order to the context longest free", "[sched]",
                   SchedModel, SchedRtl) {
    for (const int tile_bits : {0, 3})
        for (const auto& [width, height] : sizes)
            for (const Pace& pace : paces)
                for (unsigned seed = 1; seed <= 3; ++seed)
                    give_pixels<TestType>(tiled(tile_bits), frame_of(width, height), seed, pace);
}

TEMPLATE_TEST_CASE("sched gives pixels with few contexts, and with one, in tiles of every size",
                   "[sched][slow]", SchedModel, SchedRtl) {
    Config config = tiled(GENERATE(1, 2, 6));
    config.contexts = GENERATE(1, 2, 16);
    for (const auto& [width, height] : sizes)
        for (const Pace& pace : paces)
            for (unsigned seed = 6; seed <= 7; ++seed)
                give_pixels<TestType>(config, frame_of(width, height), seed, pace);
}

TEMPLATE_TEST_CASE("sched gives a pixel in every cycle, as long as contexts are free", "[sched]", SchedModel,
                   SchedRtl) {
    TestType dut{frame_of(100, 100), tiled(3)};
    dut.slot.ready = true;
    dut.tile.offer = Tile{2, 1};
    dut.eval();
    REQUIRE(dut.tile.fires());
    REQUIRE_FALSE(dut.slot.offer);
    dut.commit();
    dut.tile.offer = Tile{3, 1};   // the second tile waits inside, the third outside
    const std::uint32_t x[] = {16, 17, 16, 17, 18, 19, 18, 19, 16, 17, 16, 17},
                        y[] = {8, 8, 9, 9, 8, 8, 9, 9, 10, 10, 11, 11};
    for (std::uint32_t i = 0; i < 64; ++i) {
        dut.eval();
        REQUIRE(dut.tile.ready == (i == 0));
        REQUIRE(dut.slot.fires());
        REQUIRE(dut.slot.offer->ray == i);
        if (i < std::size(x)) REQUIRE((dut.slot.offer->x == x[i] && dut.slot.offer->y == y[i]));
        dut.commit();
    }
    dut.tile.offer.reset();
    dut.eval();
    REQUIRE_FALSE(dut.slot.offer);   // a pixel, but no context
    REQUIRE(dut.tile.ready);
    dut.pixel.offer = Pixel{};
    dut.pixel.offer->first.ray = 17;
    dut.hit.ready = true;
    dut.eval();
    REQUIRE(dut.hit.fires());
    // The 17th pixel: first row of the second quarter.
    REQUIRE((dut.hit.offer->x == 21 && dut.hit.offer->y == 8));
    REQUIRE_FALSE(dut.slot.offer);
    dut.commit();
    dut.pixel.offer.reset();
    dut.eval();
    REQUIRE(dut.slot.fires());   // in the next cycle
    REQUIRE((dut.slot.offer->ray == 17 && dut.slot.offer->x == 24 && dut.slot.offer->y == 8));
}

TEMPLATE_TEST_CASE("sched passes over a pixel outside the picture in one cycle", "[sched]", SchedModel,
                   SchedRtl) {
    TestType dut{frame_of(9, 9), tiled(3)};   // of tile (1, 1) only the first pixel is inside
    dut.slot.ready = true;
    std::vector<int> given;
    for (int cycle = 0; cycle < 140; ++cycle) {
        dut.tile.offer.reset();
        if (cycle < 2) dut.tile.offer = Tile{1, 1};
        dut.eval();
        if (dut.slot.fires()) given.push_back(cycle);
        dut.commit();
    }
    REQUIRE(given == std::vector<int>{1, 65});
}

TEMPLATE_TEST_CASE("sched passes over a tile that lies outside the picture", "[sched]", SchedModel,
                   SchedRtl) {
    TestType dut{frame_of(16, 16), tiled(3)};
    dut.slot.ready = true;
    for (int cycle = 0; cycle < 130; ++cycle) {
        dut.tile.offer.reset();
        if (cycle == 0) dut.tile.offer = Tile{2, 1};
        if (cycle == 1) dut.tile.offer = Tile{1, 2};
        if (cycle == 70) dut.tile.offer = Tile{1, 1};
        dut.eval();
        INFO("cycle " << cycle);
        REQUIRE(dut.slot.offer.has_value() == (cycle >= 129));
        dut.commit();
    }
}

TEMPLATE_TEST_CASE("sched begins a frame without what was left of the last one's tiles", "[sched]",
                   SchedModel, SchedRtl) {
    TestType dut{frame_of(9, 9), tiled(3)};
    dut.slot.ready = dut.hit.ready = true;
    const auto cycle = [&](std::optional<Tile> tile) {
        dut.tile.offer = tile;
        dut.eval();
        const std::optional<Slot> slot = dut.slot.offer;
        dut.commit();
        return slot;
    };
    for (const int passed : {0, 1, 3, 7, 9, 14, 15, 20, 31, 47, 62}) {
        dut.start(frame_of(9, 9));
        cycle(Tile{1, 1});
        const std::optional<Slot> first = cycle(Tile{1, 1});
        REQUIRE((first && first->x == 8 && first->y == 8));
        for (int i = 0; i < passed; ++i) REQUIRE_FALSE(cycle({}));
        // Those pixels would lie inside this frame. None is assigned in this cycle either.
        dut.start(frame_of(100, 100));
        for (int i = 0; i < 3; ++i) REQUIRE_FALSE(cycle({}));
        cycle(Tile{5, 0});
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::optional<Slot> slot = cycle({});
            REQUIRE((slot && slot->x == 40 + i % 2 && slot->y == i / 2));
            REQUIRE(slot->ray == first->ray + 1 + i);   // no context was used in between
        }
    }
}

TEMPLATE_TEST_CASE("sched reaches every pixel of the largest picture's rows", "[sched]", SchedModel,
                   SchedRtl) {
    for (const int tile_bits : {0, 3}) {
        const Frame frame = frame_of(16384, 2);
        std::deque<PixelCoord> expected;
        for (const Tile& tile : tiles_of(frame, tile_bits))
            in_morton_order(tile.x << tile_bits, tile.y << tile_bits, 1u << tile_bits, expected);
        std::erase_if(expected, [&](const PixelCoord& p) { return p.y >= frame.height; });
        const std::vector<PixelCoord> order = order_of<TestType>(tiled(tile_bits), frame);
        REQUIRE((order == std::vector<PixelCoord>(expected.begin(), expected.end())));
    }
}

TEMPLATE_TEST_CASE("sched gives out the colours of finished pixels", "[sched][shading]", SchedModel,
                   SchedRtl) {
    for (const auto& [width, height] : sizes)
        for (const Pace& pace : paces)
            give_pixels<TestType>(format("shading:default"), frame_of(width, height), 1, pace);
}

TEST_CASE("model and RTL of sched make the same moves in every cycle, with colours",
          "[sched][lockstep][shading]") {
    for (const Pace& pace : paces) lockstep(format("samples:small"), frame_of(40, 17), 11, pace);
}

TEST_CASE("model and RTL of sched make the same moves in every cycle", "[sched][lockstep]") {
    for (const int tile_bits : {0, 3})
        for (const auto& [width, height] : sizes)
            for (const Pace& pace : paces)
                for (unsigned seed = 11; seed <= 13; ++seed)
                    lockstep(tiled(tile_bits), frame_of(width, height), seed, pace);
}

}   // namespace rayclock::test::sched_test
