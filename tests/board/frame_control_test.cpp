// The start of a frame at the vertical blank, its flush and its count of cycles.
#include <map>

#include <catch2/catch.hpp>

#include "sim/run/gen/registers.hpp"
#include "sim/run/rtl/rtl_module.hpp"
#include "sim/run/rtl/signal.hpp"

namespace rayclock::test::frame_control_test {

using namespace rayclock;

namespace {

/// rc_frame_control with names for its pins.
class Dut {
public:
    Dut() : rtl_(named_config("ulx3s-board"), "rc_frame_control") {
        for (const char* name : {"arm", "takes", "running", "done", "wb_cyc", "wb_stb", "wb_we", "wb_adr",
                                 "wb_dat", "wb_ack", "wb_err"})
            set(name, 0);
        set("pixels_empty", 1), set("colour_empty", 1);
        rtl_.reset();
    }
    void set(const std::string& name, std::uint64_t value) {
        signal(name) = value;
        rtl_.settle();
    }
    std::uint64_t get(const std::string& name) { return std::uint64_t(signal(name)); }
    void clock(int cycles = 1) {
        for (int i = 0; i < cycles; ++i) {
            rtl_.clock();
            rtl_.settle();
        }
    }
    /// One cycle in which the input is high.
    void pulse(const std::string& name) {
        set(name, 1);
        clock();
        set(name, 0);
    }
    bool writes_start() {
        return get("wb_cyc_out") && get("wb_stb_out") && get("wb_we_out") && get("wb_dat_out") == 1 &&
               get("wb_adr_out") == register_address("Start");
    }
    /// From arm to cycle 0.
    void begin() {
        pulse("arm"), pulse("takes"), pulse("wb_ack");
        set("done", 0), set("running", 1);
    }
    /// The chip is done after this number of cycles.
    void run(int cycles) {
        clock(cycles);
        set("running", 0), set("done", 1);
    }

private:
    Signal& signal(const std::string& name) {
        return signals_.try_emplace(name, rtl_, name.c_str()).first->second;
    }
    RtlModule rtl_;
    std::map<std::string, Signal> signals_;
};

}   // namespace

TEST_CASE("a frame begins with the blank after it was armed", "[frame]") {
    Dut dut;
    dut.pulse("takes");   // nothing is armed
    CHECK_FALSE(dut.writes_start());
    dut.pulse("arm");
    for (int i = 0; i < 5; ++i) {
        CHECK(dut.get("armed"));
        CHECK_FALSE(dut.get("wb_cyc_out"));
        dut.clock();
    }
    dut.pulse("takes");
    for (int i = 0; i < 3; ++i) {   // until the chip answers
        CHECK(dut.writes_start());
        CHECK(dut.get("armed"));
        dut.clock();
    }
    dut.set("wb_ack", 1);
    CHECK_FALSE(dut.get("wb_ack_out"));   // the host did not ask
    dut.clock();
    dut.set("wb_ack", 0);
    CHECK_FALSE(dut.get("wb_cyc_out"));
    CHECK_FALSE(dut.get("armed"));
    dut.pulse("takes");   // one frame only
    CHECK_FALSE(dut.writes_start());
}

TEST_CASE("a refused start ends too", "[frame]") {
    Dut dut;
    dut.pulse("arm"), dut.pulse("takes"), dut.pulse("wb_err");
    CHECK_FALSE(dut.get("armed"));
    CHECK_FALSE(dut.get("wb_cyc_out"));
}

TEST_CASE("the flush follows the last pixel, and cycles count to its end", "[frame]") {
    Dut dut;
    for (int frame = 0; frame < 2; ++frame) {
        INFO("frame " << frame);
        dut.begin();
        CHECK(dut.get("cycles") == 0);
        CHECK_FALSE(dut.get("flushed"));
        dut.set("colour_empty", 0), dut.set("pixels_empty", 0);
        dut.run(10);
        for (int i = 0; i < 4; ++i) {   // a pixel is in the conversion
            CHECK_FALSE(dut.get("flush"));
            dut.clock();
        }
        dut.set("colour_empty", 1);
        for (int i = 0; i < 6; ++i) {
            CHECK(dut.get("flush"));
            CHECK_FALSE(dut.get("flushed"));
            dut.clock();
        }
        dut.set("pixels_empty", 1);
        dut.clock();
        for (int i = 0; i < 3; ++i) {
            CHECK(dut.get("flushed"));
            CHECK_FALSE(dut.get("flush"));
            CHECK(dut.get("cycles") == 20);
            dut.clock();
        }
    }
}

TEST_CASE("between frames the bus belongs to the host", "[frame]") {
    Dut dut;
    for (const char* name : {"wb_cyc", "wb_stb", "wb_we", "wb_ack", "wb_err"}) {
        INFO(name);
        const std::string out = std::string(name) + "_out";
        CHECK_FALSE(dut.get(out));
        dut.set(name, 1);
        CHECK(dut.get(out));
        dut.set(name, 0);
    }
    dut.set("wb_adr", 21), dut.set("wb_dat", 0x1234'5678);
    CHECK(dut.get("wb_adr_out") == 21);
    CHECK(dut.get("wb_dat_out") == 0x1234'5678);
}

}   // namespace rayclock::test::frame_control_test
