// Loaded RTL: several modules at once, each with its own assertions.
#include <memory>
#include <thread>

#include "tests/support/dut/sched_dut.hpp"
#include <catch2/catch.hpp>

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Frees contexts that were never assigned, until the queue of free contexts asserts.
bool misuse(SchedRtl& dut, int times) {
    dut.slot.ready = false;
    dut.hit.ready = true;
    dut.pixel.offer = Pixel{};
    try {
        for (int i = 0; i < times; ++i) {
            dut.eval();
            dut.commit();
        }
    } catch (const std::runtime_error&) {
        return true;
    }
    return false;
}

}   // namespace

TEST_CASE("an assertion of the RTL is heard by the module it belongs to", "[rtl]") {
    Frame frame;
    frame.width = frame.height = 4;
    const Config config = format("default");
    auto older = std::make_unique<SchedRtl>(frame, config),
         newer = std::make_unique<SchedRtl>(frame, config, 2);
    REQUIRE_FALSE(misuse(*older, 60));
    REQUIRE(misuse(*older, 10));
    newer->eval();
    REQUIRE_NOTHROW(newer->commit());
    bool heard = false;
    std::thread([&] { heard = misuse(*newer, 70); }).join();   // also from another thread
    REQUIRE(heard);
}

TEST_CASE("RTL modules can be closed in any order", "[rtl]") {
    Frame frame;
    frame.width = frame.height = 4;
    const Config config = format("default");
    for (const bool older_first : {false, true}) {
        auto older = std::make_unique<SchedRtl>(frame, config),
             newer = std::make_unique<SchedRtl>(frame, config);
        (older_first ? older : newer).reset();
        SchedRtl& left = older_first ? *newer : *older;
        left.slot.ready = true;
        left.tile.offer = Tile{0, 0};
        left.eval();
        left.commit();
        left.tile.offer.reset();
        for (std::uint32_t i = 0; i < 16; ++i) {
            left.eval();
            REQUIRE((left.slot.offer && left.slot.offer->ray == i));
            left.commit();
        }
    }
}
