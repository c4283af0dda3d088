#pragma once
// The unit sched: gives the pixels of tiles to contexts.
#include "model/base/morton.hpp"
#include "model/core/payloads.hpp"
#include "model/core/ring.hpp"

namespace rayclock {

/// Gives the pixels of its tiles, in Morton order, to free contexts, and adds the pixel to the hit of a
/// finished ray. It holds two tiles. A tile's pixel outside the picture costs a cycle without output. A fresh
/// machine uses contexts 0..T-1 first, and after that the context that has been free longest. With a stream,
/// a tile is a group of rays in sequence. Mirror of rtl/unit/sched/rc_sched.sv.
class Sched {
public:
    explicit Sched(const Config& config)
        : tile_bits_(config.tile_bits),
          pixel_bits_(config.pixel_bits),
          streams_(config.is_stream()),
          last_((1u << 2 * config.tile_bits) - 1),
          tiles_(2),
          free_(config.contexts),
          pixels_(std::size_t(config.contexts)) {
        for (int ray = 0; ray < config.contexts; ++ray) free_.push(RayNumber(ray));
    }

    /// Starts a frame, and drops the rest of the last one's tiles: pixels outside its picture.
    void start(const Frame& frame) {
        while (!tiles_.empty()) tiles_.pop();   // pixels outside the last picture
        at_ = 0;
        width_ = frame.width;
        height_ = frame.height;
        count_ = frame.ray_count;
        select_pixel();
    }
    bool tile_ready() const { return !tiles_.full(); }
    /// Returns the number of cycles from now on in which tile_ready() is certainly false, and at least 1.
    std::uint64_t before_tile() const { return tile_ready() ? 1 : std::uint64_t(last_ - at_) + 1; }
    /// pixel_valid(): a pixel of the picture is next; passing(): one outside the picture.
    bool pixel_valid() const { return inside_; }
    bool passing() const { return outside_; }
    bool slot_valid() const { return inside_ & !free_.empty(); }
    template <bool few = false> Slot slot() const { return {free_.front<few>(), x_, y_}; }
    const Slot& pixel(std::uint32_t ray) const { return pixels_[ray]; }
    bool in_use(std::uint32_t ray) const { return !free_.contains(RayNumber(ray)); }

    /// One clock edge. `slot_taken`: the slot was accepted. `tile`: the tile that arrived, or null. `hit`:
    /// the context whose hit left.
    template <bool few = false> void clock(bool slot_taken, const Tile* tile, LinkRay hit) {
        if (slot_taken) {
            pixels_[free_.front<few>()] = slot<few>();
            free_.pop();
        }
        if (slot_taken || outside_) {
            if (at_ == last_) tiles_.pop();
            at_ = (at_ + 1) & last_;
            select_pixel();
        }
        if (tile) {
            tiles_.push(*tile);
            if (tiles_.size() == 1) select_pixel();
        }
        free_.push<few>(RayNumber(hit.ray), hit.valid);
    }

private:
    /// Computes the next pixel of the tile.
    void select_pixel() {
        inside_ = outside_ = false;
        if (tiles_.empty()) return;
        if (streams_) {
            const Tile& tile = tiles_.front();
            const std::uint32_t group = tile.y << (pixel_bits_ - tile_bits_) | tile.x,
                                ray = group << 2 * tile_bits_ | at_;
            x_ = ray & ((1u << pixel_bits_) - 1);
            y_ = ray >> pixel_bits_;
            inside_ = ray < count_;
            outside_ = !inside_;
            return;
        }
        x_ = tiles_.front().x << tile_bits_ | even_bits(at_);
        y_ = tiles_.front().y << tile_bits_ | even_bits(at_ >> 1);
        inside_ = x_ < width_ && y_ < height_;
        outside_ = !inside_;
    }

    int tile_bits_, pixel_bits_;
    bool streams_;
    std::uint32_t last_, width_ = 0, height_ = 0, count_ = 0;
    std::uint32_t at_ = 0;   // pixel within the tile
    std::uint32_t x_ = 0, y_ = 0;
    bool inside_ = false, outside_ = false;
    Ring<Tile, 2> tiles_;
    RayRing free_;
    std::vector<Slot> pixels_;
};

}   // namespace rayclock
