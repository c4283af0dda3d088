// dispatch: the assignment of tiles to pipelines, and its timing.
#include "tests/support/world/sched_world.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

Config machine_of(int pipelines, int tile_bits) {
    Config config = format("default");
    config.name = std::to_string(pipelines) + " pipelines, tiles of 2^" + std::to_string(tile_bits);
    config.pipelines = pipelines;
    config.tile_bits = tile_bits;
    return config;
}

Frame frame_of(std::uint32_t width, std::uint32_t height) {
    Frame frame;
    frame.width = width;
    frame.height = height;
    return frame;
}

/// The plain rule: tiles row by row, one in every cycle with a request. The grant goes to the first requester
/// after the last one served. A served pipeline pauses its requests for a while.
class DispatchWorld {
public:
    DispatchWorld(const Config& config, unsigned seed, int ready_percent)
        : config_(config), draw_(seed), ready_percent_(ready_percent) {}

    void start(const Frame& frame) { left_ = tiles_of(frame, config_.tile_bits); }
    bool finished() const { return left_.empty(); }
    void drive(DispatchLinks& dut) {
        for (int p = 0; p < config_.pipelines; ++p)
            if (draw_.percent(ready_percent_)) ready_ |= 1u << p;
        dut.tile_ready = ready_;
    }
    void watch(const DispatchLinks& dut) {
        std::uint32_t fires = 0;
        if (!left_.empty() && ready_ != 0) {
            while (!(ready_ >> turn_ & 1)) turn_ = (turn_ + 1) % config_.pipelines;
            fires = 1u << turn_;
        }
        REQUIRE(dut.fires == fires);
        if (dut.cause) REQUIRE(*dut.cause == (fires ? 0u : left_.empty() ? 1u : 2u));
        if (!fires) return;
        REQUIRE(same(dut.tile, left_.front(), config_));
        left_.pop_front();
        ready_ &= ~fires;
        turn_ = (turn_ + 1) % config_.pipelines;
    }

private:
    Config config_;
    Draw draw_;
    int ready_percent_, turn_ = 0;
    std::uint32_t ready_ = 0;
    std::deque<Tile> left_;
};

constexpr std::pair<std::uint32_t, std::uint32_t> sizes[] = {{1, 1},  {8, 8},   {9, 8},  {64, 1},
                                                             {1, 65}, {61, 47}, {64, 48}};

/// Runs frames of all sizes, one after the other.
template <class Dut> void give_tiles(const Config& config, unsigned seed, int ready_percent) {
    Dut dut{config, int(seed)};
    DispatchWorld world{config, seed, ready_percent};
    const auto cycle = [&] {
        world.drive(dut);
        dut.eval();
        world.watch(dut);
        dut.commit();
    };
    for (int i = 0; i < 5; ++i) cycle();   // no frame yet
    for (const auto& [width, height] : sizes) {
        INFO(config.name << ", " << width << " x " << height << ", seed " << seed);
        dut.start(frame_of(width, height));
        world.start(frame_of(width, height));
        for (int i = 0; !world.finished(); ++i) {
            REQUIRE(i < 100000);
            cycle();
        }
        for (int i = 0; i < 5; ++i) cycle();
    }
}

}   // namespace

TEMPLATE_TEST_CASE("dispatch gives tiles row by row to requesting pipelines, in round-robin order",
                   "[dispatch]", DispatchModel, DispatchRtl) {
    const int pipelines = GENERATE(1, 2, 8);
    for (const int ready_percent : {3, 30, 100})
        for (unsigned seed = 1; seed <= 4; ++seed)
            give_tiles<TestType>(machine_of(pipelines, 3), seed, ready_percent);
}

TEMPLATE_TEST_CASE("dispatch gives tiles of every size", "[dispatch][slow]", DispatchModel, DispatchRtl) {
    const int pipelines = GENERATE(1, 4), tile_bits = GENERATE(0, 1, 6);
    for (unsigned seed = 1; seed <= 4; ++seed)
        give_tiles<TestType>(machine_of(pipelines, tile_bits), seed, 40);
}

TEMPLATE_TEST_CASE("dispatch gives a tile in every cycle and skips no requesting pipeline", "[dispatch]",
                   DispatchModel, DispatchRtl) {
    TestType dut{machine_of(8, 3)};
    dut.tile_ready = 0xff;
    dut.start(frame_of(80, 8));
    for (std::uint32_t i = 0; i < 10; ++i) {
        dut.eval();
        REQUIRE(dut.fires == 1u << i % 8);
        REQUIRE((dut.tile.x == i && dut.tile.y == 0));
        dut.commit();
    }
    dut.eval();
    REQUIRE(dut.fires == 0);
    dut.commit();
    dut.start(frame_of(8, 24));   // another frame keeps the round-robin position
    for (std::uint32_t i = 0; i < 3; ++i) {
        dut.eval();
        REQUIRE(dut.fires == 1u << (2 + i));
        REQUIRE((dut.tile.x == 0 && dut.tile.y == i));
        dut.commit();
    }
}

TEMPLATE_TEST_CASE("dispatch reaches the last tile of the largest picture", "[dispatch]", DispatchModel,
                   DispatchRtl) {
    const Config config = machine_of(2, 3);
    TestType dut{config};
    const std::uint32_t width = GENERATE(16384u, 16u);
    const Frame frame = frame_of(width, width == 16u ? 16384u : 16u);
    dut.start(frame);
    dut.tile_ready = 3;
    std::uint32_t wrong = 0;
    for (const Tile& tile : tiles_of(frame, config.tile_bits)) {
        dut.eval();
        wrong += dut.fires == 0 || !same(dut.tile, tile, config);
        dut.commit();
    }
    REQUIRE(wrong == 0);
    dut.eval();
    REQUIRE(dut.fires == 0);
}

TEST_CASE("model and RTL of dispatch give the same tile in every cycle", "[dispatch][lockstep]") {
    const Config config = machine_of(GENERATE(1, 2, 8), 3);
    for (unsigned seed = 11; seed <= 20; ++seed) {
        DispatchModel model{config};
        DispatchRtl rtl{config, int(seed)};
        Draw draw{seed};
        for (int frames = 0; frames < 20; ++frames) {
            const Frame frame =
                frame_of(std::uint32_t(draw.between(1, 60)), std::uint32_t(draw.between(1, 60)));
            model.start(frame);
            rtl.start(frame);
            for (int cycle = 0; cycle < 100; ++cycle) {
                INFO(config.name << ", seed " << seed << ", " << frame.width << " x " << frame.height
                                 << ", cycle " << cycle);
                rtl.tile_ready = model.tile_ready = std::uint32_t(draw.bits(config.pipelines));
                model.eval();
                rtl.eval();
                REQUIRE(model.fires == rtl.fires);
                if (model.fires) REQUIRE(same(model.tile, rtl.tile, config));
                model.commit();
                rtl.commit();
            }
        }
    }
}
