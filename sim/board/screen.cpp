// TMDS decoding by the rules of DVI 1.0, section 3, and the checks of timing.
#include "sim/board/screen.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include <fmt/format.h>

namespace rayclock {

namespace {

constexpr std::size_t max_errors = 20;
constexpr std::array<const char*, 3> channel_names{"blue", "green", "red"};

/// The control symbols, by their two control bits (DVI 1.0, section 3.3.3), bit 0 sent first.
constexpr std::array<std::uint32_t, 4> control_symbols{0b1101010100, 0b0010101011, 0b0101010100,
                                                       0b1010101011};

std::optional<std::uint8_t> control_of(std::uint32_t symbol) {
    const auto* const found = std::ranges::find(control_symbols, symbol);
    if (found == control_symbols.end()) return {};
    return std::uint8_t(found - control_symbols.begin());
}

}   // namespace

Screen::Screen(const ScreenMode& mode) : mode_(mode) {
    drawn_ = {mode.width, mode.height,
              std::vector<ScreenPicture::Pixel>(std::size_t(mode.width) * mode.height)};
    picture_ = drawn_;
}

void Screen::error(const std::string& sentence) {
    if (errors_.size() < max_errors) errors_.push_back(sentence);
}

std::string Screen::place() const {
    return has_frame_ ? fmt::format("frame {}, line {} after the vertical sync", frames_, line_)
                      : fmt::format("pixel clock {}, before the first vertical sync", seen_);
}

Screen::Decoded Screen::decode(std::size_t channel, std::uint32_t symbol) {
    int& disparity = disparity_[channel];
    if (const std::optional<std::uint8_t> control = control_of(symbol)) {
        disparity = 0;
        return {{}, *control};
    }
    const bool inverted = symbol >> 9 & 1, by_xor = symbol >> 8 & 1;
    const std::uint32_t sent = symbol & 0xff, reduced = inverted ? sent ^ 0xff : sent;
    std::uint32_t byte = reduced & 1;
    for (int i = 1; i < 8; ++i) {
        const bool changes = (reduced >> i & 1) != (reduced >> (i - 1) & 1);
        byte |= std::uint32_t(changes == by_xor) << i;
    }
    const int ones = std::popcount(byte);
    if (by_xor == (ones > 4 || (ones == 4 && !(byte & 1))))
        error(fmt::format("{}: the {} symbol {:010b} of byte {} has the wrong bit 8.", place(),
                          channel_names[channel], symbol, byte));
    // The byte as sent must not increase the imbalance. If it cannot, bit 9 is the opposite of bit 8.
    const int imbalance = std::popcount(sent) - 4;
    if (disparity == 0 || imbalance == 0 ? inverted == by_xor : (imbalance > 0) == (disparity > 0))
        error(fmt::format("{}: the {} symbol {:010b} increases the disparity {}.", place(),
                          channel_names[channel], symbol, disparity));
    disparity += 2 * std::popcount(symbol) - 10;
    largest_disparity_ = std::max(largest_disparity_, std::abs(disparity));
    return {std::uint8_t(byte), 0};
}

void Screen::pixel(const ScreenPicture::Pixel& pixel) {
    if (line_pixels_ == 0)
        first_pixel_ = clock_;
    else if (clock_ != after_pixels_)
        error(fmt::format("{}: the pixels of the line have a gap.", place()));
    after_pixels_ = clock_ + 1;
    const std::uint32_t y = line_ - (mode_.v_sync + mode_.v_back);
    if (has_frame_ && y < mode_.height && line_pixels_ < mode_.width)
        drawn_.pixels[std::size_t(y) * mode_.width + line_pixels_] = pixel;
    ++line_pixels_;
}

void Screen::end_line() {
    const auto check = [&](std::uint32_t is, std::uint32_t should, const char* what) {
        if (is != should) error(fmt::format("{}: {} {} pixel clocks, not {}.", place(), what, is, should));
    };
    check(clock_, mode_.total_width(), "the line has");
    check(sync_end_, mode_.h_sync, "the horizontal sync has");
    if (line_pixels_ > 0) {
        check(first_pixel_ - sync_end_, mode_.h_back, "the back porch has");
        check(line_pixels_, mode_.width, "the picture has");
        check(clock_ - after_pixels_, mode_.h_front, "the front porch has");
    }
    if (!has_frame_) return;
    const bool shown = line_ - (mode_.v_sync + mode_.v_back) < mode_.height;
    if (shown != (line_pixels_ > 0))
        error(fmt::format("{}: the line has {} pixels.", place(), shown ? "no" : "unexpected"));
}

void Screen::end_frame() {
    if (line_ != mode_.total_height())
        error(fmt::format("frame {} has {} lines, not {}.", frames_, line_, mode_.total_height()));
    picture_ = drawn_;
    ++frames_;
}

void Screen::syncs(bool h, bool v) {
    const bool line_begins = h_level_ && !h;
    if (!h_level_ && h) sync_end_ = clock_;
    if (line_begins) {
        if (has_line_) {
            end_line();
            ++line_;
        }
        has_line_ = true;
        clock_ = line_pixels_ = sync_end_ = 0;
    }
    if (v_level_ != v) {
        if (!line_begins)
            error(fmt::format("{}: the vertical sync changes {} pixel clocks after the horizontal sync.",
                              place(), clock_));
        if (!v) {
            if (has_frame_) end_frame();
            has_frame_ = true;
            line_ = 0;
        } else if (has_frame_ && line_ != mode_.v_sync) {
            error(fmt::format("frame {}: the vertical sync has {} lines, not {}.", frames_, line_,
                              mode_.v_sync));
        }
    }
    h_level_ = h;
    v_level_ = v;
}

void Screen::symbols(const TmdsSymbols& symbols) {
    std::array<Decoded, 3> decoded;
    for (std::size_t i = 0; i < 3; ++i) decoded[i] = decode(i, symbols[i]);
    const auto& [blue, green, red] = decoded;
    if (blue.byte.has_value() != green.byte.has_value() || blue.byte.has_value() != red.byte.has_value())
        error(fmt::format("{}: the channels disagree about the blank.", place()));
    else if (blue.byte)
        pixel({*red.byte, *green.byte, *blue.byte});
    else {
        if (green.control != 0 || red.control != 0)
            error(fmt::format("{}: the control bits of green and red are {} and {}, not 0.", place(),
                              green.control, red.control));
        syncs(blue.control & 1, blue.control >> 1);
    }
    ++clock_;
    ++seen_;
}

bool TmdsReceiver::is_aligned() const {
    return std::ranges::all_of(channels_, [](const Channel& c) { return c.phase.has_value(); });
}

void TmdsReceiver::bit(std::size_t channel, bool bit) {
    Channel& c = channels_[channel];
    c.window = c.window >> 1 | std::uint32_t(bit) << (bits_of_symbol - 1);
    const std::uint32_t phase = std::uint32_t(bits_ % bits_of_symbol);
    std::uint32_t& controls = c.controls[phase];
    controls = control_of(c.window) ? controls + 1 : 0;
    if (controls >= symbols_to_align && c.phase != phase) {
        if (c.phase && errors_.size() < max_errors)
            errors_.push_back(
                fmt::format("Bit {}: the {} channel has lost its alignment.", bits_, channel_names[channel]));
        c.phase = phase;
    }
    if (gathers_ && c.phase == phase) c.symbols.push_back(std::uint16_t(c.window));
}

void TmdsReceiver::clock_bit(bool bit) {
    if (bit && !clock_level_) {
        if (clock_rose_ && bits_ - *clock_rose_ != bits_of_symbol && errors_.size() < max_errors)
            errors_.push_back(fmt::format("Bit {}: the clock has a period of {} bits, not {}.", bits_,
                                          bits_ - *clock_rose_, bits_of_symbol));
        clock_rose_ = bits_;
    }
    clock_level_ = bit;
}

void TmdsReceiver::pairs(std::uint32_t pairs) {
    for (std::uint32_t half = 0; half < 2; ++half) {
        for (std::size_t i = 0; i < 3; ++i) bit(i, pairs >> (2 * i + half) & 1);
        clock_bit(pairs >> (6 + half) & 1);
        // Gathering begins in the middle of a symbol, so channels may be skewed by less than half a symbol.
        gathers_ = gathers_ ||
                   (is_aligned() &&
                    bits_ % bits_of_symbol == (*channels_[0].phase + bits_of_symbol / 2) % bits_of_symbol);
        ++bits_;
    }
    while (std::ranges::none_of(channels_, [](const Channel& c) { return c.symbols.empty(); })) {
        TmdsSymbols symbols{};
        for (std::size_t i = 0; i < 3; ++i) {
            symbols[i] = channels_[i].symbols.front();
            channels_[i].symbols.pop_front();
        }
        screen_.symbols(symbols);
    }
}

}   // namespace rayclock
