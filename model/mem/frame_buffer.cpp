// Schedules the frame buffer's reads and writes.
#include "model/mem/frame_buffer.hpp"

#include <bit>

namespace rayclock {

FrameBuffer::Read FrameBuffer::read() {
    const std::uint32_t id = std::uint32_t(std::countr_zero(free_ids_));
    free_ids_ &= free_ids_ - 1;
    --due_;
    ++scanned_;
    const Read read{id, base_ + screen_at_};
    screen_at_ = (screen_at_ + 1) % words;
    return read;
}

std::uint32_t FrameBuffer::write() {
    --pixel_words_;
    ++written_;
    const std::uint32_t addr = base_ + words + pixels_at_;
    pixels_at_ = (pixels_at_ + 1) % words;
    return addr;
}

void FrameBuffer::clock(std::uint32_t pixels, bool had_turn, bool had_room) {
    had_turn_ = had_turn | (had_turn_ & !had_room);
    if (writes_) {
        pixels_ += pixels;
        pixel_words_ += pixels_ / pixels_of_word;
        pixels_ %= pixels_of_word;
    }
    if (!scans_) return;
    phase_ += words_per_ms;
    for (; phase_ >= khz_; phase_ -= khz_) ++due_;
    const std::uint32_t under_way = ids - std::uint32_t(std::popcount(free_ids_));
    backlog_ = std::max(backlog_, due_ + under_way);
}

}   // namespace rayclock
