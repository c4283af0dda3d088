// A cycle of the simulated board.
#include "sim/board/simulated_board.hpp"

#include <fmt/format.h>

#include "model/board/scan_out.hpp"
#include "sim/board/identity.hpp"

namespace rayclock {

namespace {

constexpr std::uint64_t shift_khz = 5 * ScreenTiming::khz;

std::string module_of(const Config& config, const BoardShape& shape) {
    if (config.pipelines != 1)
        throw UserError(fmt::format("the board's chip has one pipeline, and this configuration has {}",
                                    config.pipelines));
    const SdramPart& part = sdram_part(shape.sdram);
    return fmt::format(
        "rc_board ClkKhz={} Baud={} ColumnBits={} InitUs={} GateClock={} ConfigHash=64'h{:016x}", shape.khz,
        shape.baud, part.column_bits, shape.initial_wait_us, int(shape.gates_clock), config_hash(config));
}

/// The SDRAM waits after power-on for the time that the shape says.
SdramPart part_of(const BoardShape& shape) {
    SdramPart part = sdram_part(shape.sdram);
    part.initial_wait = std::int64_t(shape.initial_wait_us) * 1'000'000;
    return part;
}

}   // namespace

SimulatedBoard::SimulatedBoard(const Config& config, const BoardShape& shape)
    : shape_(shape),
      rtl_(config, module_of(config, shape), shape.seed),
      sdram_(part_of(shape), shape.khz),
      receiver_(screen_),
      from_host_(1e3 * shape.khz / shape.baud),
      to_host_(1e3 * shape.khz / shape.baud),
      rx_(rtl_, "rx"),
      tx_(rtl_, "tx"),
      led_(rtl_, "led"),
      tmds_(rtl_, "tmds"),
      pixel_clk_(rtl_, "pixel_clk"),
      pixel_rst_(rtl_, "pixel_rst"),
      shift_clk_(rtl_, "shift_clk"),
      shift_rst_(rtl_, "shift_rst"),
      pins_(rtl_) {
    pins_.set_dq(0);
    reset();
}

void SimulatedBoard::reset() {
    rx_ = 1, pixel_clk_ = 0, shift_clk_ = 0, pixel_rst_ = 0, shift_rst_ = 0;
    for (int i = 0; i < 10; ++i) {   // the video's registers see the reset
        pixel_clk_ = 1, shift_clk_ = 1;
        rtl_.settle();
        pixel_clk_ = 0, shift_clk_ = 0;
        rtl_.settle();
    }
    rtl_.reset();
    pixel_rst_ = 1, shift_rst_ = 1;
    rtl_.settle();
    for (int i = 0; i < 100; ++i) step();   // the receiver sees that the line is idle
}

/// The edges of the shift clock up to the chip's next edge; every fifth is one of the pixel clock.
void SimulatedBoard::shift() {
    for (shift_time_ += shift_khz; shift_time_ >= std::uint64_t(shape_.khz);
         shift_time_ -= std::uint64_t(shape_.khz)) {
        receiver_.pairs(std::uint32_t(tmds_));
        shift_clk_ = 1;
        pixel_clk_ = ++shift_edges_ % 5 == 0;
        rtl_.settle();
        shift_clk_ = 0, pixel_clk_ = 0;
        rtl_.settle();
    }
}

void SimulatedBoard::step() {
    rx_ = from_host_.level(cycle_);
    rtl_.settle();
    if (shape_.is_lit) shift();
    to_host_.see(cycle_, tx_ != 0);
    // The SDRAM's clock lags by three quarters of a period: it samples the pins before the cycle ends. Its
    // data reach the input registers in the next cycle.
    pins_.set_dq(sdram_.dq().value_or(std::uint16_t(0xdead)));
    sdram_.clock(pins_.get());
    rtl_.clock();
    ++cycle_;
}

Channel::Moved SimulatedBoard::exchange(std::span<const std::uint8_t> out, std::span<std::uint8_t> in,
                                        LinkTime most) {
    for (const std::uint8_t byte : out) from_host_.bytes.push_back(byte);
    const std::uint64_t end = cycle_ + std::uint64_t(most.count()) * std::uint64_t(shape_.khz) / 1000;
    while (cycle_ < end && to_host_.bytes.empty()) step();
    Moved moved{out.size(), 0};
    for (; moved.read < in.size() && !to_host_.bytes.empty(); ++moved.read) {
        in[moved.read] = to_host_.bytes.front();
        to_host_.bytes.pop_front();
    }
    return moved;
}

LinkTime SimulatedBoard::now() { return LinkTime(cycle_ * 1000 / std::uint64_t(shape_.khz)); }

void SimulatedBoard::watch(std::uint64_t pictures, const Progress& progress) {
    const std::uint64_t until = screen_.frames() + pictures;
    // A whole picture takes 16.8 ms; after a change it may take two until the next whole one.
    const std::uint64_t begin = cycle_, most = (pictures + 2) * 17 * std::uint64_t(shape_.khz);
    while (screen_.frames() < until && cycle_ - begin < most) {
        step();
        constexpr std::uint64_t cycles_of_report = 4096;
        if (progress && cycle_ % cycles_of_report == 0) progress("watching the screen", cycle_ - begin, most);
    }
}

}   // namespace rayclock
