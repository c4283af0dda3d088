// A cycle of the pixel writer.
#include "model/board/pixel_writer.hpp"

#include <algorithm>

namespace rayclock {

bool PixelWriter::empty() const { return input_.empty() && std::ranges::none_of(buffers_, &Buffer::used); }

std::size_t PixelWriter::entered(const PixelPlace& pixel) const {
    for (std::size_t i = 0; i < buffers; ++i)
        if (buffers_[i].open && buffers_[i].block_x == pixel.x / 4 && buffers_[i].block_y == pixel.y / 4)
            return i;
    return std::size_t(std::ranges::find(buffers_, false, &Buffer::used) - buffers_.begin());
}

std::size_t PixelWriter::chosen(bool flush) const {
    const auto oldest = [&](auto candidate) {
        std::size_t best = buffers;
        for (std::size_t i = 0; i < buffers; ++i)
            if (candidate(buffers_[i]) && (best == buffers || buffers_[i].began < buffers_[best].began))
                best = i;
        return best;
    };
    const std::size_t full = oldest([](const Buffer& b) { return b.open && b.full; });
    if (full != buffers) return full;
    return flush || waits_ ? oldest([](const Buffer& b) { return b.open; }) : buffers;
}

bool PixelWriter::sleeps(bool flush) const {
    if (enters_ || (!input_.empty() && entered(input_.front()) != buffers)) return false;
    for (const Buffer& b : buffers_)
        if (b.full != (b.open && b.there == 0xffff)) return false;
    if (state_ == State::idle) return chosen(flush) == buffers && waits_ == !input_.empty();
    if (waits_) return false;
    return state_ == State::request || state_ == State::beats;
}

void PixelWriter::clock(const Inputs& in) {
    const bool accepts = in.pixel && ready();
    const bool is_idle = state_ == State::idle, looks = !input_.empty() && !enters_;
    const std::size_t goes = is_idle && (!looks || waits_) ? chosen(in.flush) : buffers;
    const std::size_t found = looks ? entered(input_.front()) : buffers;

    waits_ = is_idle && looks && found == buffers;
    for (Buffer& b : buffers_) b.full = b.open && b.there == 0xffff;

    // The head of the queue enters the buffer that it found a cycle ago.
    if (enters_) {
        const PixelPlace pixel = input_.front();
        input_.pop();
        Buffer& buffer = buffers_[found_];
        if (!buffer.open) buffer = {true, true, buffer.full, pixel.x / 4, pixel.y / 4, 0, begun_++};
        buffer.there = std::uint16_t(buffer.there | 1U << (4 * (pixel.y % 4) + pixel.x % 4));
    }
    enters_ = looks && found != buffers;
    found_ = found;
    if (accepts) input_.push(*in.pixel);

    // The write under way.
    switch (state_) {
        case State::idle:
            if (goes == buffers) break;
            sent_ = goes;
            buffers_[goes].open = false;
            state_ = State::read;
            break;
        case State::read: state_ = State::multiply; break;
        case State::multiply: state_ = State::add; break;
        case State::add:
            address_ = in.base + buffers_[sent_].block_y * ((in.width + 3) / 4) + buffers_[sent_].block_x;
            beats_ = 0;
            state_ = State::request;
            break;
        case State::request:
            if (in.req_ready) state_ = State::beats;
            beats_ += in.next;
            break;
        case State::beats:
            beats_ += in.next;
            if (beats_ < beats_of_line) break;
            buffers_[sent_].used = false;
            state_ = State::idle;
            break;
    }
}

}   // namespace rayclock
