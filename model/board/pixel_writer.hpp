#pragma once
// The pixel writer in time: which block of finished pixels is written when.
#include <array>
#include <cstdint>
#include <optional>

#include "model/core/ring.hpp"

namespace rayclock {

/// Gathers pixels into blocks of 4x4 and writes the blocks. It holds no colours. Read the outputs, then call
/// clock() with the inputs of the same cycle. Mirror of rtl/board/pixels/rc_pixel_writer.sv, which describes
/// the rules.
class PixelWriter {
public:
    struct PixelPlace {
        std::uint32_t x = 0, y = 0;   ///< pixels
    };
    struct Inputs {
        std::uint32_t base = 0, width = 0;   ///< number of the first line; pixels. Both constant until
                                             ///< empty().
        bool flush = false;
        std::optional<PixelPlace> pixel{};      ///< offered
        bool req_ready = false, next = false;   ///< next: a beat of the write is taken
    };

    /// True if an offered pixel is accepted in this cycle.
    bool ready() const { return !input_.full(); }
    /// True if no pixel is inside.
    bool empty() const;
    bool requests() const { return state_ == State::request; }
    std::uint32_t address() const { return address_; }   ///< a line's number; valid with requests()
    /// Returns the words of the requested line that have a pixel, from word 0 in bit 0. The others are
    /// masked.
    std::uint16_t words() const { return buffers_[sent_].there; }
    void clock(const Inputs& in);

    /// True if clock() changes nothing without a pixel, and without an answer to the request under way.
    bool sleeps(bool flush) const;

private:
    static constexpr std::size_t buffers = 4;
    static constexpr std::uint32_t beats_of_line = 32;
    enum class State : std::uint8_t { idle, read, multiply, add, request, beats };

    struct Buffer {
        bool used = false, open = false;   ///< open: pixels of its block enter it
        bool full = false;                 ///< it had all its pixels a cycle ago
        std::uint32_t block_x = 0, block_y = 0;
        std::uint16_t there = 0;   ///< words with a pixel
        std::uint64_t began = 0;   ///< number of its block, in the order of first pixels
    };

    /// Returns the buffer that a pixel enters, or `buffers` if it must wait.
    std::size_t entered(const PixelPlace& pixel) const;
    /// Returns the buffer to write next, or `buffers` if there is none.
    std::size_t chosen(bool flush) const;

    bool waits_ = false;    ///< a pixel has waited for a buffer while no write was under way
    bool enters_ = false;   ///< the head of the queue has found a buffer
    std::size_t found_ = buffers;
    Ring<PixelPlace, 2> input_{2};
    std::array<Buffer, buffers> buffers_{};
    std::uint64_t begun_ = 0;
    State state_ = State::idle;
    std::size_t sent_ = 0;
    std::uint32_t address_ = 0, beats_ = 0;   ///< beats_: taken of the write under way
};

}   // namespace rayclock
