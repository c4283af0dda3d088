// Builds the RTL that the tests of the board's video load.
#include "tests/support/machine/build_all.hpp"
#include "tests/board/video/video_dut.hpp"
#include <catch2/catch.hpp>

using namespace rayclock;

TEST_CASE("the RTL of the board's video is built", "[.build]") {
    std::vector<test::RtlJob> jobs;
    for (const char* module : {"rc_pixel_writer", "rc_tmds", "rc_video", "rc_video_fifo Width=16"})
        jobs.push_back({module, "board", test::video_config()});
    for (const char* khz : {"75000", "62500", "50000", "100000"})
        jobs.push_back({std::string("rc_scan_out ChipKhz=") + khz, "board", test::video_config()});
    test::build_all(jobs);
    SUCCEED("all are there");
}
