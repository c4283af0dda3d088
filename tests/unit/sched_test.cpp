// sched: which pixel goes to which context, and which pixel a hit belongs to.
#include "tests/support/sched_dut.hpp"
#include "tests/support/traffic.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

Frame frame_of(std::uint32_t width, std::uint32_t height) {
    Frame frame;
    frame.width = width;
    frame.height = height;
    return frame;
}

/// Rays that end in any order, and the plain rule: pixels row by row; contexts 0, 1, 2 ... and then as they came free.
class SchedWorld {
public:
    SchedWorld(const Frame& frame, const Config& config, unsigned seed, const Flow& flow)
        : frame_(frame), config_(config), flow_(flow), draw_(seed) {
        for (std::uint32_t ray = 0; ray < std::uint32_t(config.contexts); ++ray) free_.push_back(ray);
    }
    bool finished() const { return hits_ == frame_.width * frame_.height; }

    void drive(SchedLinks& dut) {
        if (!closest_ && !running_.empty() && !draw_.percent(flow_.idle_percent) && draw_.coin()) {
            const auto at = running_.begin() + draw_.below(int(running_.size()));
            closest_ = random_payload<Closest>(draw_, config_);
            closest_->ray = at->ray;
            pixel_ = *at;
            running_.erase(at);
        }
        dut.closest.offer = closest_;
        dut.slot.ready = !draw_.percent(flow_.idle_percent);
        dut.hit.ready = !draw_.percent(flow_.stall_percent);
    }

    void watch(const SchedLinks& dut) {
        const bool more = given_ < frame_.width * frame_.height;
        REQUIRE(dut.slot.offer.has_value() == (more && !free_.empty()));
        REQUIRE(dut.closest.ready == dut.hit.ready);
        REQUIRE(dut.hit.offer.has_value() == closest_.has_value());
        if (closest_) REQUIRE(same(*dut.hit.offer, HitOut{pixel_.x, pixel_.y, *closest_}, config_));
        if (dut.slot.offer) {
            const Slot& slot = *dut.slot.offer;
            REQUIRE((slot.x == given_ % frame_.width && slot.y == given_ / frame_.width && slot.ray == free_.front()));
        }
        if (dut.slot.fires()) {
            running_.push_back(*dut.slot.offer);
            free_.pop_front();
            ++given_;
        }
        if (dut.hit.fires()) {   // free from the next cycle on
            free_.push_back(closest_->ray);
            closest_.reset();
            ++hits_;
        }
    }

private:
    Frame frame_;
    Config config_;
    Flow flow_;
    Draw draw_;
    std::deque<std::uint32_t> free_;
    std::vector<Slot> running_;
    std::optional<Closest> closest_;
    Slot pixel_;
    std::uint32_t given_ = 0, hits_ = 0;
};

constexpr std::pair<int, int> sizes[] = {{1, 1}, {1, 9}, {64, 1}, {13, 5}, {40, 17}};

template <class Dut> void give_pixels(const Config& config, const Frame& frame, unsigned seed, const Flow& flow) {
    INFO(config.name << ", " << frame.width << " x " << frame.height << ", " << flow.name << ", seed " << seed);
    Dut dut{frame, config, int(seed)};
    SchedWorld world{frame, config, seed, flow};
    for (int cycle = 0; !world.finished(); ++cycle) {
        INFO("cycle " << cycle);
        REQUIRE(cycle < 100000);
        world.drive(dut);
        dut.eval();
        world.watch(dut);
        dut.commit();
    }
    dut.closest.offer.reset();
    for (int i = 0; i < 5; ++i) {
        dut.eval();
        REQUIRE_FALSE(dut.slot.offer);
        dut.commit();
    }
}

void lockstep(const Config& config, const Frame& frame, unsigned seed, const Flow& flow) {
    SchedModel model{frame, config};
    SchedRtl rtl{frame, config, int(seed)};
    SchedWorld world{frame, config, seed, flow};
    for (int cycle = 0; !world.finished(); ++cycle) {
        INFO(config.name << ", " << frame.width << " x " << frame.height << ", " << flow.name << ", seed " << seed << ", cycle " << cycle);
        world.drive(model);
        static_cast<SchedLinks&>(rtl) = model;
        model.eval();
        rtl.eval();
        REQUIRE(same(model.slot, rtl.slot, config));
        REQUIRE(same(model.closest, rtl.closest, config));
        REQUIRE(same(model.hit, rtl.hit, config));
        world.watch(model);
        model.commit();
        rtl.commit();
    }
}

} // namespace

TEMPLATE_TEST_CASE("sched gives pixels row by row to the context longest free", "[sched]", SchedModel, SchedRtl) {
    for (const auto& [width, height] : sizes)
        for (const Flow& flow : flows)
            for (unsigned seed = 1; seed <= 3; ++seed)
                give_pixels<TestType>(format("default"), frame_of(std::uint32_t(width), std::uint32_t(height)), seed, flow);
}

TEMPLATE_TEST_CASE("sched gives pixels with few contexts, and with one", "[sched][slow]", SchedModel, SchedRtl) {
    Config config = format("small");
    config.contexts = GENERATE(1, 2, 16);
    for (const auto& [width, height] : sizes)
        for (const Flow& flow : flows) give_pixels<TestType>(config, frame_of(std::uint32_t(width), std::uint32_t(height)), 7, flow);
}

TEMPLATE_TEST_CASE("sched gives a pixel in every cycle from the first, as long as contexts are free", "[sched]", SchedModel, SchedRtl) {
    const Config config = format("default");
    TestType dut{frame_of(100, 100), config};
    dut.slot.ready = true;
    for (std::uint32_t i = 0; i < 64; ++i) {
        dut.eval();
        REQUIRE(dut.slot.fires());
        REQUIRE(dut.slot.offer->x == i);
        dut.commit();
    }
    dut.eval();
    REQUIRE_FALSE(dut.slot.offer);
    dut.closest.offer = Closest{};
    dut.closest.offer->ray = 17;
    dut.hit.ready = true;
    dut.eval();
    REQUIRE(dut.hit.fires());
    REQUIRE(dut.hit.offer->x == 17);
    REQUIRE_FALSE(dut.slot.offer);
    dut.commit();
    dut.closest.offer.reset();
    dut.eval();
    REQUIRE(dut.slot.fires());   // in the next cycle
    REQUIRE(dut.slot.offer->ray == 17);
}

TEMPLATE_TEST_CASE("sched reaches the last pixel of the largest picture's row", "[sched]", SchedModel, SchedRtl) {
    const Frame frame = frame_of(16384, 2);
    const Config config = format("default");
    TestType dut{frame, config};
    dut.slot.ready = dut.hit.ready = true;
    std::uint32_t given = 0;
    for (int cycle = 0; given < 2 * 16384; ++cycle) {
        REQUIRE(cycle < 3 * 16384);
        dut.eval();
        const std::optional<Slot> slot = dut.slot.offer;
        dut.commit();
        dut.closest.offer.reset();
        if (!slot) continue;
        if (slot->x != given % 16384 || slot->y != given / 16384) FAIL("pixel " << given);
        dut.closest.offer = Closest{};
        dut.closest.offer->ray = slot->ray;   // every ray ends at once
        ++given;
    }
}

TEST_CASE("model and rtl of sched make the same moves in every cycle", "[sched][lockstep]") {
    for (const auto& [width, height] : sizes)
        for (const Flow& flow : flows)
            for (unsigned seed = 11; seed <= 13; ++seed) lockstep(format("default"), frame_of(std::uint32_t(width), std::uint32_t(height)), seed, flow);
}
