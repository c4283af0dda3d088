#pragma once
#include <algorithm>
#include <cstdint>

#include "model/core/config.hpp"
#include "model/core/dram_parts.hpp"

namespace rayclock {

/// The load of the picture on the memory, beside the rays': a screen that is read, and finished pixels that
/// are written. Two pictures of 640x480 pixels lie at the memory's end, 32 bits a pixel, so that 16 pixels
/// are a word of 64 bytes: one is shown and the other drawn.
///
/// Scan-out reads 60 pictures a second, spread evenly over time: the lines that a screen keeps before it
/// bridge its blanking. Since a screen cannot wait, a word that is due goes before the chip's requests,
/// though not twice running: a memory that is too slow for the screen goes on serving the chip. Of finished
/// pixels every 16 are one write, as if tiles were gathered into words; a write goes when the chip asks for
/// nothing, or before its requests if most_pixel_words are waiting. A picture of more pixels goes round
/// within its buffer: how often rows change stays the same.
class FrameBuffer {
public:
    static constexpr std::uint32_t pixels_of_word = 16, words = 640 * 480 / pixels_of_word,
                                   words_per_ms = words * 60 / 1000;
    static constexpr std::int64_t bytes = 2 * std::int64_t(words) * 64;
    static constexpr double screen_bytes_per_second = double(words_per_ms) * 1000 * 64;
    static constexpr int ids = 8;   ///< words of the screen under way at once
    static constexpr std::uint32_t most_pixel_words = 4;

    FrameBuffer(const Config& config, int khz)
        : khz_(std::uint32_t(khz)), scans_(config.scan_out != 0), writes_(config.pixel_writes != 0) {
        if (const DramPart* part = config.dram_part())
            base_ = std::uint32_t((capacity_bytes(*part) * config.dram_channels - bytes) / 64);
    }

    /// A word of the screen is due and can be asked for.
    bool wants_read() const { return due_ > 0 && free_ids_ != 0; }
    /// A word of pixels can be written.
    bool wants_write() const { return pixel_words_ > 0; }
    /// One of these goes before the chip's request.
    bool goes_first() const { return !had_turn_ && (wants_read() || pixel_words_ >= most_pixel_words); }

    struct Read {
        std::uint32_t id = 0, addr = 0;   ///< id: below `ids`
    };
    /// The word that wants_read(), which is asked for.
    Read read();
    void answered(std::uint32_t id) { free_ids_ |= 1U << id; }
    /// The address of the word that wants_write(), which is written.
    std::uint32_t write();

    /// The end of a cycle, in which so many pixels were finished. `had_turn`: read() or write() was called;
    /// `had_room`: the memory had room for a request.
    void clock(std::uint32_t pixels, bool had_turn, bool had_room);
    /// Cycles until a word of the screen is due.
    std::uint64_t quiet() const {
        if (!scans_) return ~std::uint64_t(0);
        return wants_read() ? 0 : (khz_ - phase_ - 1) / words_per_ms;
    }
    /// The same as clock(0, false, had_room) so often, not beyond quiet().
    void skip(std::uint64_t cycles, bool had_room) {
        had_turn_ &= !had_room;
        if (scans_) phase_ += std::uint32_t(cycles) * words_per_ms;
    }

    std::uint64_t scanned() const { return scanned_; }   ///< words of the screen asked for
    std::uint64_t written() const { return written_; }   ///< words of pixels
    /// Most words that were due and had not come: so many, at least, a screen must hold.
    std::uint32_t backlog() const { return backlog_; }

private:
    std::uint32_t khz_, base_ = 0;
    bool scans_, writes_, had_turn_ = false;   ///< had_turn_: the last request was its own
    std::uint32_t phase_ = 0, due_ = 0;        ///< phase_: words_per_ms a cycle, khz_ a word
    std::uint32_t free_ids_ = (1U << ids) - 1, screen_at_ = 0, backlog_ = 0;
    std::uint32_t pixels_ = 0, pixel_words_ = 0, pixels_at_ = 0;
    std::uint64_t scanned_ = 0, written_ = 0;
};

}   // namespace rayclock
