#pragma once
// The environment of sched in a test: tiles that arrive and rays that end in any order, and the plain rule
// that assigns pixels to contexts.
#include "tests/support/dut/sched_dut.hpp"
#include "tests/support/world/traffic.hpp"

namespace rayclock::test {

struct PixelCoord {
    std::uint32_t x = 0, y = 0;
    friend bool operator==(const PixelCoord&, const PixelCoord&) = default;
};

/// Appends the pixels of a square in Morton order: its four quarters, upper left, upper right, lower left,
/// lower right.
inline void in_morton_order(std::uint32_t x, std::uint32_t y, std::uint32_t side,
                            std::deque<PixelCoord>& to) {
    if (side == 1) {
        to.push_back({x, y});
        return;
    }
    const std::uint32_t half = side / 2;
    in_morton_order(x, y, half, to);
    in_morton_order(x + half, y, half, to);
    in_morton_order(x, y + half, half, to);
    in_morton_order(x + half, y + half, half, to);
}

/// Returns all tiles of a picture, row by row.
inline std::deque<Tile> tiles_of(const Frame& frame, int tile_bits) {
    const std::uint32_t side = 1u << tile_bits;
    std::deque<Tile> tiles;
    for (std::uint32_t y = 0; y * side < frame.height; ++y)
        for (std::uint32_t x = 0; x * side < frame.width; ++x) tiles.push_back({x, y});
    return tiles;
}

/// Handles tiles in order of arrival, at most two, with pixels in Morton order. A pixel outside the picture
/// costs a cycle. Contexts are assigned as 0, 1, 2, ... and then in the order in which they become free.
class SchedWorld {
public:
    SchedWorld(const Frame& frame, const Config& config, unsigned seed, const Pace& pace)
        : frame_(frame),
          config_(config),
          flow_(pace),
          draw_(seed),
          coming_(tiles_of(frame, config.tile_bits)) {
        if (seed % 2) shuffle();
        for (std::uint32_t ray = 0; ray < std::uint32_t(config.contexts); ++ray) free_.push_back(ray);
    }
    bool finished() const { return finished_pixels_ == frame_.width * frame_.height; }

    void drive(SchedLinks& dut) {
        if (!tile_ && !coming_.empty() && !draw_.percent(flow_.idle_percent)) {
            tile_ = coming_.front();
            coming_.pop_front();
        }
        if (!pixel_ && !running_.empty() && !draw_.percent(flow_.idle_percent) && draw_.coin()) {
            const auto at = running_.begin() + draw_.below(int(running_.size()));
            pixel_ = random_payload<Pixel>(draw_, config_);
            pixel_->first.ray = at->ray;
            place_ = *at;
            running_.erase(at);
        }
        dut.tile.offer = tile_;
        dut.pixel.offer = pixel_;
        dut.slot.ready = !draw_.percent(flow_.idle_percent);
        dut.hit.ready = !draw_.percent(flow_.stall_percent);
    }

    void watch(const SchedLinks& dut) {
        const bool has_pixel = !tiles_.empty() && inside(tiles_.front().front());
        REQUIRE(dut.tile.ready == (tiles_.size() < 2));
        REQUIRE(dut.slot.offer.has_value() == (has_pixel && !free_.empty()));
        REQUIRE(dut.pixel.ready == dut.hit.ready);
        REQUIRE(dut.hit.offer.has_value() == pixel_.has_value());
        if (pixel_)
            REQUIRE(same(*dut.hit.offer, HitOut{place_.x, place_.y, pixel_->first, pixel_->colour}, config_));
        if (dut.slot.offer) {
            const Slot& slot = *dut.slot.offer;
            REQUIRE((PixelCoord{slot.x, slot.y} == tiles_.front().front() && slot.ray == free_.front()));
        }
        if (dut.cause)
            REQUIRE(*dut.cause == (dut.slot.fires() ? 0u : dut.slot.offer ? 3u : has_pixel ? 1u : 2u));
        if (dut.slot.fires()) {
            running_.push_back(*dut.slot.offer);
            free_.pop_front();
        }
        if (dut.slot.fires() || (!tiles_.empty() && !has_pixel)) {
            tiles_.front().pop_front();
            if (tiles_.front().empty()) tiles_.pop_front();
        }
        if (dut.tile.fires()) {   // its pixels start in the next cycle
            tiles_.emplace_back();
            in_morton_order(tile_->x << config_.tile_bits, tile_->y << config_.tile_bits,
                            1u << config_.tile_bits, tiles_.back());
            tile_.reset();
        }
        if (dut.hit.fires()) {   // free from the next cycle
            free_.push_back(pixel_->first.ray);
            pixel_.reset();
            ++finished_pixels_;
        }
    }

private:
    bool inside(const PixelCoord& p) const { return p.x < frame_.width && p.y < frame_.height; }
    void shuffle() {
        for (std::size_t i = coming_.size(); i > 1; --i)
            std::swap(coming_[i - 1], coming_[std::size_t(draw_.below(int(i)))]);
    }

    Frame frame_;
    Config config_;
    Pace flow_;
    Draw draw_;
    std::deque<Tile> coming_;
    std::optional<Tile> tile_;
    std::deque<std::deque<PixelCoord>> tiles_;   // remaining pixels of each tile present
    std::deque<std::uint32_t> free_;
    std::vector<Slot> running_;
    std::optional<Pixel> pixel_;
    Slot place_;
    std::uint32_t finished_pixels_ = 0;
};

}   // namespace rayclock::test
