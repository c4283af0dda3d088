#pragma once
#include "model/core/payloads.hpp"
#include "model/core/ring.hpp"

namespace rayclock {

/// Gives the pixels of its tiles, in Morton order, to free contexts, and puts the pixel to the hit when its
/// ray is done. Holds two tiles. A pixel of a tile that lies outside the picture costs a cycle in which
/// nothing is given. A fresh machine uses contexts 0..T-1 first; after that the one that has been free
/// longest. Mirror of rtl/unit/sched/rc_sched.sv.
class Sched {
public:
    explicit Sched(const Config& config)
        : tile_bits_(config.tile_bits),
          last_((1u << 2 * config.tile_bits) - 1),
          tiles_(2),
          free_(config.contexts),
          pixels_(std::size_t(config.contexts)) {
        for (int ray = 0; ray < config.contexts; ++ray) free_.push(RayNumber(ray));
    }

    /// A new frame. What is left of the last one's tiles, pixels outside its picture, is dropped.
    void start(const Frame& frame) {
        while (!tiles_.empty()) tiles_.pop();   // pixels outside the last picture
        at_ = 0;
        width_ = frame.width;
        height_ = frame.height;
        look();
    }
    bool tile_ready() const { return !tiles_.full(); }
    /// A pixel of the picture is at hand; passing: one that lies outside.
    bool pixel_valid() const { return inside_; }
    bool passing() const { return outside_; }
    bool slot_valid() const { return inside_ & !free_.empty(); }
    Slot slot() const { return {free_.front(), x_, y_}; }
    const Slot& pixel(std::uint32_t ray) const { return pixels_[ray]; }
    bool in_use(std::uint32_t ray) const { return !free_.contains(RayNumber(ray)); }

    /// One clock edge: whether the slot was taken, the tile that came (null if none) and the context whose
    /// hit left.
    void clock(bool slot_taken, const Tile* tile, OnLink hit) {
        if (slot_taken) {
            pixels_[free_.front()] = slot();
            free_.pop();
        }
        if (slot_taken || outside_) {
            if (at_ == last_) tiles_.pop();
            at_ = (at_ + 1) & last_;
            look();
        }
        if (tile) {
            tiles_.push(*tile);
            if (tiles_.size() == 1) look();
        }
        free_.push(RayNumber(hit.ray), hit.there);
    }

private:
    /// Every second bit of a number, from the lowest on.
    static std::uint32_t even_bits(std::uint32_t m) {
        m &= 0x555;
        m = (m | m >> 1) & 0x333;
        m = (m | m >> 2) & 0xf0f;
        return (m | m >> 4) & 0x3f;
    }
    /// At the pixel that is now at hand.
    void look() {
        inside_ = outside_ = false;
        if (tiles_.empty()) return;
        x_ = tiles_.front().x << tile_bits_ | even_bits(at_);
        y_ = tiles_.front().y << tile_bits_ | even_bits(at_ >> 1);
        inside_ = x_ < width_ && y_ < height_;
        outside_ = !inside_;
    }

    int tile_bits_;
    std::uint32_t last_, width_ = 0, height_ = 0;
    std::uint32_t at_ = 0;   // pixel of the tile
    std::uint32_t x_ = 0, y_ = 0;
    bool inside_ = false, outside_ = false;
    Ring<Tile, 2> tiles_;
    RayRing free_;
    std::vector<Slot> pixels_;
};

}   // namespace rayclock
