#pragma once
// A screen with a DVI input: decodes TMDS, checks the timing, and gives the picture. Written from the DVI 1.0
// specification and the timing of 640x480 at 60 Hz (CEA-861, format 1), independently of the encoder.
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace rayclock {

/// The symbols of one pixel clock: 10 bits each of channel 0 (blue and syncs), 1 (green) and 2 (red). Bit 0
/// is sent first.
using TmdsSymbols = std::array<std::uint16_t, 3>;

/// A picture as a screen shows it, row by row. A pixel is red, green and blue.
struct ScreenPicture {
    using Pixel = std::array<std::uint8_t, 3>;
    std::uint32_t width = 0, height = 0;
    std::vector<Pixel> pixels;

    const Pixel& at(std::uint32_t x, std::uint32_t y) const { return pixels[std::size_t(y) * width + x]; }
    bool operator==(const ScreenPicture&) const = default;
};

/// Widths in pixel clocks and heights in lines. Both syncs are active low.
struct ScreenMode {
    std::uint32_t width = 640, h_front = 16, h_sync = 96, h_back = 48;
    std::uint32_t height = 480, v_front = 10, v_sync = 2, v_back = 33;

    std::uint32_t total_width() const { return width + h_front + h_sync + h_back; }
    std::uint32_t total_height() const { return height + v_front + v_sync + v_back; }
};

/// Takes one set of symbols per pixel clock. It checks that each symbol is the one that DVI prescribes, and
/// that syncs, porches and pixels have their places. Checks of lines begin with the first horizontal sync,
/// and checks of frames with the first vertical sync.
class Screen {
public:
    explicit Screen(const ScreenMode& mode = {});

    void symbols(const TmdsSymbols& symbols);

    /// The number of whole frames since the first vertical sync, and the last of them.
    std::uint64_t frames() const { return frames_; }
    const ScreenPicture& picture() const { return picture_; }
    /// The first twenty faults, one sentence each.
    const std::vector<std::string>& errors() const { return errors_; }
    /// The largest |ones - zeros| that a channel had sent between two blanks.
    int largest_disparity() const { return largest_disparity_; }

private:
    /// A decoded symbol: a byte, or the two control bits of the blank.
    struct Decoded {
        std::optional<std::uint8_t> byte;
        std::uint8_t control = 0;
    };

    Decoded decode(std::size_t channel, std::uint32_t symbol);
    void pixel(const ScreenPicture::Pixel& pixel);
    void syncs(bool h, bool v);
    void end_line();
    void end_frame();
    void error(const std::string& sentence);
    std::string place() const;

    ScreenMode mode_;
    std::array<int, 3> disparity_{};   ///< ones - zeros since the blank
    int largest_disparity_ = 0;
    bool h_level_ = true, v_level_ = true;   ///< of the syncs
    bool has_line_ = false, has_frame_ = false;
    /// Pixel clocks since the leading edge of the horizontal sync: now, at the sync's end and at the first
    /// and after the last pixel of the line. Lines since the leading edge of the vertical sync.
    std::uint32_t clock_ = 0, sync_end_ = 0, first_pixel_ = 0, after_pixels_ = 0, line_ = 0;
    std::uint32_t line_pixels_ = 0;
    ScreenPicture drawn_, picture_;
    std::uint64_t frames_ = 0, seen_ = 0;   ///< seen_: pixel clocks
    std::vector<std::string> errors_;
};

/// Finds the symbols in the bits of a cable, and gives them to a screen. The bits come in pairs, as from
/// rtl/board/video/rc_video.sv. A channel is aligned when twelve control symbols follow one another.
/// Channels may be skewed by less than half a symbol.
class TmdsReceiver {
public:
    explicit TmdsReceiver(Screen& screen) : screen_(screen) {}

    /// Takes the four pairs of a shift clock: blue in the lowest two bits, green, red, clock. The lower bit
    /// of a pair comes first.
    void pairs(std::uint32_t pairs);

    bool is_aligned() const;
    const std::vector<std::string>& errors() const { return errors_; }   ///< of alignment and clock

private:
    static constexpr std::uint32_t bits_of_symbol = 10, symbols_to_align = 12;

    struct Channel {
        std::uint32_t window = 0;   ///< the last ten bits, the first of them in bit 0
        std::array<std::uint32_t, bits_of_symbol> controls{};   ///< control symbols in a row, by phase
        std::optional<std::uint32_t> phase;
        std::deque<std::uint16_t> symbols;
    };
    void bit(std::size_t channel, bool bit);
    void clock_bit(bool bit);

    Screen& screen_;
    std::array<Channel, 3> channels_;
    bool gathers_ = false;     ///< all channels are aligned
    std::uint64_t bits_ = 0;   ///< of each channel so far
    bool clock_level_ = false;
    std::optional<std::uint64_t> clock_rose_;
    std::vector<std::string> errors_;
};

}   // namespace rayclock
