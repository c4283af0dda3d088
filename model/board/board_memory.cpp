// A cycle of the board's memory.
#include "model/board/board_memory.hpp"

#include <algorithm>

#include "model/base/error.hpp"

namespace rayclock {

constexpr int read_delay = 1;   // as in rc_board

void check_board_clock(const Config& config, int khz) {
    if (!config.is_board()) return;
    if (khz < ScreenTiming::khz)
        throw UserError("dram=board needs a clock of at least " + std::to_string(ScreenTiming::khz / 1000) +
                        " MHz, the screen's pixel clock");
    check_sdram_clock(sdram_part(config.board_sdram), khz);
}

BoardMemory::BoardMemory(const Config& config, int khz)
    : part_((check_board_clock(config, khz), sdram_part(config.board_sdram))),
      shape_{.chip_khz = std::uint32_t(khz)},
      clients_(sdram_clocks(part_, khz, read_delay), config.mem_id_bits()),
      scan_(shape_),
      colour_(config.has_shade()),
      addresses_(std::size_t(1) << config.mem_id_bits()) {
    offer();
}

void BoardMemory::start(std::uint32_t width, std::uint32_t height) {
    while (colour_.holds() || !writer_.empty()) step(nullptr, nullptr, true);
    drawn_base_ = Screens::base(part_, 0);
    shown_ = {Screens::base(part_, 1), width, height, Screens::doubles(width, height)};
    for (skip_quiet(); !clients_.init_done() || !scan_.takes(); skip_quiet()) step(nullptr, nullptr, false);
    for (int i = 0; i < start_cycles; ++i) step(nullptr, nullptr, false);
}

void BoardMemory::clock(const Line* request, const PixelPlace* pixel) {
    const Sdram& sdram = clients_.sdram();
    const Outcome outcome = sdram.write_beat().valid || sdram.read_beat().valid ? Outcome::busy
                            : !clients_.holds()                                 ? Outcome::starved
                            : sdram.refreshing()                                ? Outcome::refresh
                                                                                : Outcome::latency;
    ++outcomes_[std::size_t(outcome)];
    step(request, pixel, false);
}

void BoardMemory::step(const Line* request, const PixelPlace* pixel, bool flush) {
    if (request) {
        offers_.chip = {true, request->id, request->addr};
        addresses_[request->id] = request->addr;
        ++reads_;
    }
    const MemoryClients::Ready ready = clients_.ready();
    scanned_ += offers_.scan.valid && ready.scan;
    written_ += offers_.pixels.valid && ready.pixels;

    const bool leaves = colour_.valid() && writer_.ready();
    PixelWriter::Inputs in{drawn_base_, shown_.width, flush, {}, ready.pixels, clients_.pixels_next()};
    if (colour_.valid()) in.pixel = colour_.place();
    if (scan_.nears()) clients_.align();
    scan_.clock({shown_, ready.scan, clients_.scan_beat()});
    writer_.clock(in);
    colour_.clock(leaves, pixel);
    clients_.clock(offers_);
    offer();
}

/// Skips the cycles in which nothing changes without the chip. No pixel may be inside.
void BoardMemory::skip_quiet() {
    if (!writer_.sleeps(false)) return;
    const std::uint64_t cycles = std::min(clients_.quiet_cycles(), scan_.quiet());
    scan_.skip(cycles);
    clients_.skip(cycles);
    colour_.skip(cycles);
}

/// Determines what scan-out and pixel writer offer in the next cycle.
void BoardMemory::offer() {
    offers_ = {};
    offers_.scan = {scan_.requests(), scan_.address(), scan_.is_urgent()};
    offers_.pixels = {writer_.requests(), writer_.address()};
}

}   // namespace rayclock
