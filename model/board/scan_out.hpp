#pragma once
// Scan-out in time: which line of the shown picture is requested when, and which pixels come too late.
#include <cstdint>

namespace rayclock {

/// The timing of 640x480 at 60 Hz, in pixel clocks and lines.
struct ScreenTiming {
    static constexpr std::uint32_t shown_width = 640, total_width = 800;
    static constexpr std::uint32_t shown_height = 480, total_height = 525;
    static constexpr int khz = 25'000;   ///< of the pixel clock
    static constexpr double frames_per_second() { return khz * 1e3 / (total_width * total_height); }
};

/// A picture in memory, as scan-out takes it over. It lies in blocks of 4x4 pixels, one line of 64 bytes
/// each.
struct ShownPicture {
    std::uint32_t base = 0;                ///< number of its first line
    std::uint32_t width = 0, height = 0;   ///< in pixels, below 2^16
    bool doubled = false;                  ///< each pixel is shown as 2x2

    std::uint32_t blocks_across() const { return (width + 3) / 4; }
    std::uint32_t blocks_down() const { return (height + 3) / 4; }
    /// True if it has pixels and fits the screen. Any other picture is shown as black.
    bool is_shown() const {
        return width > 0 && height > 0 && width << doubled <= ScreenTiming::shown_width &&
               height << doubled <= ScreenTiming::shown_height;
    }
    bool operator==(const ShownPicture&) const = default;
};

/// Returns the longest time between two lines of memory that causes no underrun, in cycles of the chip. The
/// memory may serve scan-out only when it is urgent. A row of blocks is shown for four lines of the screen,
/// or eight if doubled, and in this time the next row falls due. The sum of this time and of the memory's
/// latency must be at most worst_delay_cycles(). The latency must be at most ScanOut::Shape::in_flight times
/// this time.
constexpr std::uint32_t worst_line_cycles(const ShownPicture& picture, std::uint32_t chip_khz,
                                          std::uint32_t pixel_khz) {
    const std::uint64_t pixel_clocks = std::uint64_t(ScreenTiming::total_width) * (4U << picture.doubled);
    return std::uint32_t(pixel_clocks * chip_khz / (std::uint64_t(pixel_khz) * ((picture.width + 3) / 4)));
}

/// Returns the longest time from when a block falls due to its last beat, in cycles of the chip. The last
/// block of a row falls due when the beam enters the horizontal blank before that row. So the time is the
/// blank and the screen's pixels left of the block. Four pixel clocks remain for the pipeline.
constexpr std::uint32_t worst_delay_cycles(const ShownPicture& picture, std::uint32_t chip_khz,
                                           std::uint32_t pixel_khz) {
    const std::uint32_t left = (ScreenTiming::shown_width - (picture.width << picture.doubled)) / 2,
                        blank = ScreenTiming::total_width - ScreenTiming::shown_width,
                        of_block = 4 * ((picture.width + 3) / 4 - 1) << picture.doubled;
    return std::uint32_t(std::uint64_t(blank + left + of_block - 4) * chip_khz / pixel_khz);
}

/// Scan-out: the beam, the requests of lines, and the count of pixels that had not arrived. It holds no
/// colours. Read the outputs, then call clock() with the inputs of the same cycle. Mirror of
/// rtl/board/video/rc_scan_out.sv, which describes the rules.
class ScanOut {
public:
    struct Shape {
        std::uint32_t chip_khz = 75000, pixel_khz = 25000;   ///< only their ratio matters
        std::uint32_t in_flight = 4;   ///< lines offered or requested that have not arrived
    };
    struct Inputs {
        ShownPicture picture;
        bool req_ready = false, beat = false;   ///< beat: 16 bits of a requested line arrive
    };

    explicit ScanOut(const Shape& shape) : shape_(shape), phase_(-std::int64_t(shape.pixel_khz)) {}

    /// True if the picture is taken over at the end of this cycle.
    bool takes() const { return ticks() && h_ == 0 && v_ == ScreenTiming::shown_height; }
    /// True 100 pixel clocks before takes(). If the memory is fast enough, no line is in flight then.
    bool nears() const {
        return ticks() && h_ == ScreenTiming::total_width - near && v_ == ScreenTiming::shown_height - 1;
    }
    bool requests() const { return req_valid_; }
    std::uint32_t address() const { return address_; }   ///< a line's number; valid with requests()
    bool is_urgent() const { return urgent_; }           ///< the offered line fell due in an earlier cycle
    /// Pixels that had not arrived when they were shown, at most 65535.
    std::uint32_t underruns() const { return underruns_; }
    void clock(const Inputs& in);

    /// Cycles in which no input causes a request, a takeover or a count, and nears() is false. 0 while a
    /// request or an answer is in flight.
    std::uint64_t quiet() const;
    /// Has the effect of that many calls of clock(), at most quiet().
    void skip(std::uint64_t cycles);

private:
    static constexpr std::uint32_t beats_of_line = 32, max_underruns = 0xffff, opens_nothing = 0xff;
    static constexpr std::uint32_t near = 100;   ///< pixel clocks from nears() to takes()

    /// A pixel of the picture on its way from the beam to the row buffers.
    struct Fetch {
        bool valid = false;
        std::uint32_t row = 0, block = 0;
    };

    bool ticks() const { return phase_ + shape_.pixel_khz >= shape_.chip_khz; }
    Fetch under_beam() const;
    bool row_ends() const;
    /// Ticks before the next event: a row opens, a picture is taken over, or nears() is true.
    std::uint32_t ticks_to_event() const;

    Shape shape_;
    /// Grows by pixel_khz per cycle; at chip_khz the beam moves. It starts below 0 because the RTL registers
    /// the tick.
    std::int64_t phase_;
    std::uint32_t h_ = 0, v_ = ScreenTiming::shown_height;
    ShownPicture shown_;
    bool taken_ = false, start_ = false, opens_ = false;   ///< events of the cycle before
    std::uint32_t opened_ = 0;                             ///< rows of blocks that may have been requested
    /// Blocks of opened rows that are not yet offered, and those that are not yet due.
    std::uint32_t to_request_ = 0, to_fall_ = 0, pace_ = 0;
    bool req_valid_ = false, urgent_ = false;
    std::uint32_t address_ = 0, next_address_ = 0, pending_ = 0, drop_ = 0;
    std::uint32_t beat_ = 0, arrived_ = 0, arrived_row_ = 0;
    Fetch s1_, s2_;
    bool s3_late_ = false;
    std::uint32_t underruns_ = 0;
};

}   // namespace rayclock
