#pragma once
// The board's memory from the chip's side: finished pixels, scan-out, arbiter and SDRAM together.
#include <array>
#include <cstdint>
#include <vector>

#include "model/board/memory_clients.hpp"
#include "model/board/pixel_colour.hpp"
#include "model/board/pixel_writer.hpp"
#include "model/board/scan_out.hpp"
#include "model/core/config.hpp"

namespace rayclock {

/// Two pictures of 640x480 pixels at the end of the memory. One is shown while the other is drawn.
struct Screens {
    static constexpr std::uint32_t width = 640, height = 480, lines = width * height / 16;
    /// Returns the number of the first line of picture 0 or 1.
    static std::uint32_t base(const SdramPart& part, std::uint32_t picture) {
        return std::uint32_t(part.bytes() / 64) - (2 - picture) * lines;
    }
    /// True if the screen shows each pixel of such a picture as 2x2.
    static bool doubles(std::uint32_t width, std::uint32_t height) {
        return 2 * width <= Screens::width && 2 * height <= Screens::height;
    }
};

/// Throws UserError if the configuration has the board's memory and the board does not allow this clock.
void check_board_clock(const Config& config, int khz);

/// The part of the board behind the chip's memory port and pixel port. It holds ids, addresses and places, no
/// data. Mirror of rtl/board/rc_board.sv without host link, video and chip.
///
/// A frame starts at the beginning of the screen's vertical blank: rc_board holds the host's write to `start`
/// until then, and begins a refresh 100 pixel clocks before it. So the number of a frame's cycles does not
/// depend on earlier events. start() brings the model to the frame's cycle 0.
class BoardMemory {
public:
    using PixelPlace = PixelWriter::PixelPlace;

    /// Cycles from the one in which scan-out takes over a picture to the frame's cycle 0: the bus access of
    /// the register `start`, and the chip's preparation.
    static constexpr int start_cycles = 20;

    /// Throws UserError if the board does not allow this clock.
    BoardMemory(const Config& config, int khz);

    /// Brings the board to cycle 0 of a frame with this picture, while the screen shows a picture of the same
    /// size. Pixels of the last frame are written first.
    void start(std::uint32_t width, std::uint32_t height);

    struct Line {
        std::uint32_t id = 0, addr = 0;
    };
    /// True if a request of the chip would be accepted.
    bool ready() const { return clients_.ready().chip; }
    /// The answer to the chip, which is valid for one cycle.
    bool answers() const { return clients_.answers(); }
    Line answer() const { return {clients_.answer_id(), addresses_[clients_.answer_id()]}; }
    /// True if the next finished pixel would be accepted.
    bool accepts_pixel() const { return colour_.ready(); }

    /// One clock edge, with the accepted request and the accepted pixel, or null.
    void clock(const Line* request, const PixelPlace* pixel);

    /// A cycle has data on the bus, a request that waits for its row or its turn, a request that waits for a
    /// refresh, or no request. cycles() counts since the construction, without the cycles of start().
    enum class Outcome { busy, latency, refresh, starved };   // as MemoryOutcome
    std::uint64_t cycles(Outcome outcome) const { return outcomes_[std::size_t(outcome)]; }
    std::uint64_t reads() const { return reads_; }       ///< lines for the chip
    std::uint64_t scanned() const { return scanned_; }   ///< lines for the screen
    std::uint64_t written() const { return written_; }   ///< lines with pixels
    std::uint32_t underruns() const { return scan_.underruns(); }
    const Sdram& sdram() const { return clients_.sdram(); }

private:
    void step(const Line* request, const PixelPlace* pixel, bool flush);
    void skip_quiet();
    void offer();

    SdramPart part_;
    ScanOut::Shape shape_;
    MemoryClients clients_;
    ScanOut scan_;
    PixelWriter writer_;
    PixelColour colour_;
    ShownPicture shown_;
    std::uint32_t drawn_base_ = 0;
    ClientOffers offers_;                    // of scan-out and pixel writer in this cycle
    std::vector<std::uint32_t> addresses_;   // [id] of requests in flight
    std::array<std::uint64_t, 4> outcomes_{};
    std::uint64_t reads_ = 0, scanned_ = 0, written_ = 0;
};

}   // namespace rayclock
