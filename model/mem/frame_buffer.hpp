#pragma once
// Traffic of a screen and of finished pixels on the memory.
#include <algorithm>
#include <cstdint>

#include "model/core/config.hpp"
#include "model/core/dram_parts.hpp"

namespace rayclock {

/// The load of the picture on the memory, in addition to the rays': a screen reads a picture, and the chip
/// writes finished pixels. Two pictures of 640x480 pixels lie at the memory's end, with 32 bits per pixel, so
/// 16 pixels make a word of 64 bytes. One picture is shown while the other is drawn.
///
/// Scan-out reads 60 pictures per second, spread evenly over time: a screen's line buffer bridges its
/// blanking. A screen cannot wait, so a due word has priority over the chip's requests, but not twice in a
/// row. So a memory that is too slow for the screen still serves the chip.
///
/// Every 16 finished pixels make one write, as if tiles were gathered into words. A write goes
/// when the chip requests nothing, or before its requests if max_pixel_words are waiting. A picture with
/// more pixels wraps within its buffer, which keeps the rate of row changes.
class FrameBuffer {
public:
    static constexpr std::uint32_t pixels_of_word = 16, words = 640 * 480 / pixels_of_word,
                                   words_per_ms = words * 60 / 1000;
    static constexpr std::int64_t bytes = 2 * std::int64_t(words) * 64;
    static constexpr double screen_bytes_per_second = double(words_per_ms) * 1000 * 64;
    static constexpr int ids = 8;   ///< most words of the screen in flight
    static constexpr std::uint32_t max_pixel_words = 4;

    FrameBuffer(const Config& config, int khz)
        : khz_(std::uint32_t(khz)), scans_(config.scan_out), writes_(config.pixel_writes) {
        if (const DramPart* part = config.dram_part())
            base_ = std::uint32_t((capacity_bytes(*part) * config.dram_channels - bytes) / 64);
    }

    /// True if a word of the screen is due and an id is free.
    bool wants_read() const { return due_ > 0 && free_ids_ != 0; }
    /// True if a word of pixels is ready to be written.
    bool wants_write() const { return pixel_words_ > 0; }
    /// True if a read or write has priority over the chip's request.
    bool goes_first() const { return !had_turn_ && (wants_read() || pixel_words_ >= max_pixel_words); }

    struct Read {
        std::uint32_t id = 0, addr = 0;   ///< id: below `ids`
    };
    /// Takes the due word of the screen; requires wants_read().
    Read read();
    void answered(std::uint32_t id) { free_ids_ |= 1U << id; }
    /// Returns the address of the next word of pixels, which is written; requires wants_write().
    std::uint32_t write();

    /// Ends a cycle in which `pixels` pixels were finished. `had_turn`: read() or write() was called.
    /// `had_room`: the memory had room for a request.
    void clock(std::uint32_t pixels, bool had_turn, bool had_room);
    /// Cycles until a word of the screen is due.
    std::uint64_t quiet() const {
        if (!scans_) return ~std::uint64_t(0);
        return wants_read() ? 0 : (khz_ - phase_ - 1) / words_per_ms;
    }
    /// Has the effect of that many calls of clock(0, false, had_room); must not go beyond quiet().
    void skip(std::uint64_t cycles, bool had_room) {
        had_turn_ &= !had_room;
        if (scans_) phase_ += std::uint32_t(cycles) * words_per_ms;
    }

    std::uint64_t scanned() const { return scanned_; }   ///< words of the screen requested
    std::uint64_t written() const { return written_; }   ///< words of pixels written
    /// The largest number of words that were due at the same time and had not arrived. A screen needs a
    /// buffer of at least this size.
    std::uint32_t backlog() const { return backlog_; }

private:
    std::uint32_t khz_, base_ = 0;
    bool scans_, writes_, had_turn_ = false;   ///< had_turn_: the last request was the picture's
    /// `phase_` grows by words_per_ms per cycle. When it reaches `khz_`, a word is due.
    std::uint32_t phase_ = 0, due_ = 0;
    std::uint32_t free_ids_ = (1U << ids) - 1, screen_at_ = 0, backlog_ = 0;
    std::uint32_t pixels_ = 0, pixel_words_ = 0, pixels_at_ = 0;
    std::uint64_t scanned_ = 0, written_ = 0;
};

}   // namespace rayclock
