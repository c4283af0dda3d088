// The chip with the model of the board's memory: model and RTL in lockstep, also with a disturbance.
#include <catch2/catch.hpp>

#include "sim/run/request/request.hpp"
#include "tests/support/machine/build_all.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::chip_lockstep_test {

using namespace rayclock;

namespace {

/// The smaller chip of the two, which does not shade.
Config chip() { return load_config({"ulx3s", {"dram=board", "scan_out=1", "pixel_writes=1"}}); }

}   // namespace

TEST_CASE("the RTL of the board's chip is built", "[.build]") {
    build_all({{"rc_chip", "board", chip()}});
    SUCCEED("it is there");
}

TEST_CASE("model and RTL agree at the board's memory, under every back-pressure", "[chip]") {
    for (const Disturbance disturbance :
         {Disturbance{0, 0, 1}, Disturbance{20, 0, 2}, Disturbance{0, 50, 3}, Disturbance{7, 20, 4}})
        for (const int khz : {75'000, 62'500, 125'000}) {
            INFO(khz << " kHz, jitter " << disturbance.jitter << ", stall " << disturbance.stall_percent
                     << " %");
            Job job = make_shot("gears:1", {32, 24}, chip()).job;
            job.khz = khz;
            check_lockstep(job, disturbance);
        }
}

TEST_CASE("two frames at the board's memory agree", "[chip]") {
    const Job job = make_shot("gears:1", {32, 24}, chip()).job;
    std::vector<RecordedFrame> frames;
    for (int f = 0; f < 2; ++f) frames.push_back(record_frame(job, job.frame));
    check_lockstep(job, frames);
    check_lockstep(job, frames, {7, 20, 5});
}

TEST_CASE("a frame's figures leave out the time before its cycle 0", "[chip][stats]") {
    const int khz = 75'000;
    Memory memory(chip(), khz, {});
    memory.start_frame(32, 24);
    CHECK(memory.stats() == MemoryStats{});

    const std::uint64_t cycles = 100'000, interval = 584;   // cycles between refreshes: 7.8 us at 75 MHz,
                                                            // rounded down
    for (std::uint64_t i = 0; i < cycles; ++i) memory.clock(nullptr);
    const MemoryStats frame = memory.stats();
    // The blank takes 108,000 cycles, so only the first two rows of the picture's blocks are read: 16 lines,
    // of which two were accepted in the 20 cycles before cycle 0.
    CHECK(frame.scanned == 2 * 32 / 4 - 2);
    CHECK(frame.refreshes >= cycles / interval - 1);
    CHECK(frame.refreshes <= cycles / interval + 1);

    memory.start_frame(32, 24);
    CHECK(memory.stats() == frame);
}

}   // namespace rayclock::test::chip_lockstep_test
