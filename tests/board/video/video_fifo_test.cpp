// The queue between the chip's clock and the pixel clock alone.
#include <vector>

#include "tests/board/video/video_dut.hpp"
#include <catch2/catch.hpp>

namespace video_fifo_test {

using namespace rayclock;
using namespace rayclock::test;

/// rc_video_fifo with both clocks. Entries are numbers that count up.
class Fifo {
public:
    explicit Fifo(std::uint32_t chip_khz)
        : chip_khz_(chip_khz), rtl_(video_config(), "rc_video_fifo Width=16") {
        valid_ = 0, pixel_clk_ = 0, pixel_rst_ = 0;
        for (int i = 0; i < 4; ++i) edge(true, true);
        rtl_.reset();
        pixel_rst_ = 1;
    }
    /// Simulates until and with the next edge of the chip's clock, in which an entry may be written.
    void clock(bool writes) {
        valid_ = writes, data_ = written;
        written += writes;
        chip_time_ += 25000;
        while (pixel_time_ + chip_khz_ < chip_time_) pixel_edge(false);
        if (pixel_time_ + chip_khz_ == chip_time_)
            pixel_edge(true);
        else
            edge(true, false);
    }
    bool overflow() { return overflow_; }
    bool underflow() { return underflow_; }

    std::uint16_t written = 0;
    std::vector<std::uint16_t> read;
    std::uint64_t gaps = 0, pauses = 0;   ///< pixel clocks without an entry since the first; in so many
                                          ///< pauses

private:
    void pixel_edge(bool with_chip) {
        pixel_time_ += chip_khz_;
        edge(with_chip, true);
        if (out_valid_)
            read.push_back(std::uint16_t(out_));
        else
            pause();
    }
    void pause() {
        if (read.empty()) return;
        pauses += read.size() != paused_at_;
        paused_at_ = read.size();
        ++gaps;
    }
    void edge(bool chip, bool pixel) {
        rtl_.settle();
        pixel_clk_ = pixel;
        if (chip)
            rtl_.clock();
        else
            rtl_.settle();
        pixel_clk_ = 0;
        rtl_.settle();
    }

    std::uint32_t chip_khz_;
    std::uint64_t chip_time_ = 0, pixel_time_ = 0;
    std::size_t paused_at_ = 0;   ///< entries before the last pause
    RtlModule rtl_;
    Signal valid_{rtl_, "valid"}, data_{rtl_, "data"}, pixel_clk_{rtl_, "pixel_clk"},
        pixel_rst_{rtl_, "pixel_rst"};
    Signal overflow_{rtl_, "overflow"}, underflow_{rtl_, "underflow"}, out_valid_{rtl_, "valid_out"},
        out_{rtl_, "data_out"};
};

TEST_CASE("the video queue bridges ticks that come up to three pixels early or late", "[board][fifo]") {
    const std::uint32_t khz = GENERATE(50000U, 62500U, 75000U, 100000U, 26000U);
    CAPTURE(khz);
    Fifo fifo(khz);
    Draw draw{khz};
    std::uint64_t due = 0;   // 25000 times the cycles so far
    int lead = 0;
    for (int i = 0; i < 300'000; ++i) {
        due += 25000;
        if (draw.below(20) == 0) lead = draw.between(-3, 3);
        const bool writes = std::int64_t(fifo.written) < std::int64_t(due / khz % 65536) + lead;
        if (due / khz > 60000) break;   // before the numbers wrap
        fifo.clock(writes);
    }
    REQUIRE_FALSE(fifo.overflow());
    REQUIRE_FALSE(fifo.underflow());
    REQUIRE(fifo.gaps == 0);
    REQUIRE(fifo.read.size() > 50'000);
    for (std::size_t i = 0; i < fifo.read.size(); ++i) REQUIRE(fifo.read[i] == i);
}

TEST_CASE("a writer that is too fast overflows the video queue, and no entry is out of order",
          "[board][fifo]") {
    Fifo fifo(75000);
    for (int i = 0; i < 3000; ++i) fifo.clock(i % 5 < 2);   // 30 MHz
    REQUIRE(fifo.overflow());
    REQUIRE_FALSE(fifo.underflow());
    for (std::size_t i = 1; i < fifo.read.size(); ++i) REQUIRE(fifo.read[i] > fifo.read[i - 1]);
    REQUIRE(fifo.read.size() > 900);
}

TEST_CASE("a writer that is too slow lets the video queue fill by half again", "[board][fifo]") {
    Fifo fifo(75000);
    for (int i = 0; i < 4000; ++i) fifo.clock(i % 4 == 0);   // 18.75 MHz
    REQUIRE(fifo.underflow());
    REQUIRE_FALSE(fifo.overflow());
    for (std::size_t i = 0; i < fifo.read.size(); ++i) REQUIRE(fifo.read[i] == i);
    // In each pause the writer sends about eight entries, which takes eleven pixel clocks.
    REQUIRE(fifo.pauses > 10);
    REQUIRE(fifo.gaps >= 8 * fifo.pauses);
    REQUIRE(fifo.gaps <= 14 * fifo.pauses);
}

}   // namespace video_fifo_test
