#pragma once
// The conversion of finished pixels to the screen's bytes. Mirror of rtl/board/pixels/rc_pixel_colour.sv.
#include <array>
#include <cstdint>

#include "model/board/pixel_writer.hpp"
#include "model/core/ring.hpp"

namespace rayclock {

/// Returns the colour that the screen shows for a hit of a chip that does not shade: red, green, blue. The
/// bits of the primitive's number plus 1 go to red, green and blue in turn. The lowest bit becomes the
/// highest bit of red (colour map of labels, PASCAL VOC development kit). Black if nothing was hit.
constexpr std::array<std::uint8_t, 3> label_colour(bool found, std::uint32_t primitive) {
    std::array<std::uint8_t, 3> colour{};
    const std::uint32_t label = primitive + 1;
    for (unsigned bit = 0; found && bit < 24; ++bit)
        colour[bit % 3] |= std::uint8_t((label >> bit & 1) << (7 - bit / 3));
    return colour;
}

/// The timing of the conversion. It holds at most four pixels and keeps their order. A chip that shades
/// delivers a pixel at most every three cycles, and the pixel can leave eleven cycles later. Without shading
/// a pixel can enter in every cycle and leave in the next one.
class PixelColour {
public:
    using PixelPlace = PixelWriter::PixelPlace;

    explicit PixelColour(bool shaded) : interval_(shaded ? 3 : 1), latency_(shaded ? 11 : 1) {}

    bool ready() const { return !pixels_.full() && now_ >= open_at_; }
    bool valid() const { return !pixels_.empty() && pixels_.front().due <= now_; }
    /// Returns the pixel on offer; requires valid().
    PixelPlace place() const { return pixels_.front().place; }
    /// True if a pixel is inside.
    bool holds() const { return !pixels_.empty(); }

    /// One clock edge. `leaves`: the pixel on offer is accepted. `enters`: the accepted pixel, or null.
    void clock(bool leaves, const PixelPlace* enters) {
        if (leaves) pixels_.pop();
        if (enters) {
            pixels_.push({*enters, now_ + latency_});
            open_at_ = now_ + interval_;
        }
        ++now_;
    }
    /// Has the effect of that many calls of clock(false, nullptr).
    void skip(std::uint64_t cycles) { now_ += cycles; }

private:
    struct Inside {
        PixelPlace place;
        std::uint64_t due = 0;
    };
    std::uint64_t interval_, latency_, now_ = 0, open_at_ = 0;
    Ring<Inside> pixels_{4};
};

}   // namespace rayclock
