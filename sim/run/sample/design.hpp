#pragma once
// The design of a sample: the parts of a frame, and the random choice among them. docs/guide/sampling.md
// explains it.
#include <cstdint>
#include <vector>

#include "model/base/rng.hpp"
#include "model/core/config.hpp"
#include "model/core/frame.hpp"
#include "model/unit/sched/dispatch.hpp"

namespace rayclock::sample {

/// The pixels of a frame in the order of dispatch, as slots: tile by tile, and in Morton order within a tile.
/// A slot of a tile may lie outside the picture.
class SlotOrder {
public:
    SlotOrder(const Frame& frame, int tile_bits);

    struct Pixel {
        std::uint32_t x, y;
    };
    std::uint32_t columns() const { return columns_; }   ///< tiles in a row
    std::uint32_t tiles() const { return columns_ * rows_; }
    std::uint64_t tile_slots() const { return std::uint64_t(1) << 2 * tile_bits_; }
    std::uint64_t slots() const { return tiles() * tile_slots(); }
    Pixel pixel(std::uint64_t slot) const;
    bool is_inside(const Pixel& p) const { return p.x < width_ && p.y < height_; }
    /// Returns the number of pixels of the picture in the tiles before this one.
    std::uint64_t pixels_before(std::uint32_t tile) const;
    Tile tile(std::uint32_t number) const { return {number % columns_, number / columns_}; }

private:
    std::uint32_t width_, height_, columns_, rows_;
    int tile_bits_;
};

/// Lengths in tiles. A part is measured. The warm-up before it and the tail after it are only simulated.
struct Lengths {
    std::uint32_t warm_up = 0, part = 0, tail = 0;
};
/// Returns the lengths for a machine: multiples of the rays that it has in flight.
Lengths lengths_of(const Config& config);

/// The parts of a frame. The first and the last one are always measured, because the frame starts and drains
/// in them.
struct Parts {
    SlotOrder order;
    Lengths lengths;
    std::uint32_t count = 0;
    std::uint32_t first_tile(std::uint32_t part) const { return part * lengths.part; }
    /// Returns the tile after the last one. The last part may be up to twice as long as the others.
    std::uint32_t end_tile(std::uint32_t part) const {
        return part + 1 == count ? order.tiles() : first_tile(part + 1);
    }
};
Parts parts_of(const Frame& frame, const Config& config);

/// Parts of similar work. Two of them are measured.
struct Stratum {
    std::uint32_t size = 0;
    std::uint32_t chosen[2] = {0, 0};
};
constexpr std::uint32_t least_strata = 10;

/// Sorts the parts between the first and the last by their work, and divides them into strata with at least
/// three parts each. Apart from that, the total work of all strata is as equal as possible. Chooses two parts
/// of each stratum at random.
std::vector<Stratum> draw(const std::vector<std::uint64_t>& work, std::uint32_t strata, Rng& rng);

/// Returns a number below n, each with the same probability.
inline std::uint64_t below(Rng& rng, std::uint64_t n) {
    const std::uint64_t limit = ~std::uint64_t(0) - ~std::uint64_t(0) % n;
    std::uint64_t value = rng.next();
    while (value >= limit) value = rng.next();
    return value % n;
}

}   // namespace rayclock::sample
