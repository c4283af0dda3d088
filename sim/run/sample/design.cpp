// Parts, strata and their random choice. Integers only, so that a seed gives the same sample everywhere.
#include "sim/run/sample/design.hpp"

#include <algorithm>
#include <numeric>

#include "model/base/morton.hpp"

namespace rayclock::sample {

SlotOrder::SlotOrder(const Frame& frame, int tile_bits)
    : width_(frame.width),
      height_(frame.height),
      columns_((frame.width + (1u << tile_bits) - 1) >> tile_bits),
      rows_((frame.height + (1u << tile_bits) - 1) >> tile_bits),
      tile_bits_(tile_bits) {}

SlotOrder::Pixel SlotOrder::pixel(std::uint64_t slot) const {
    const auto number = std::uint32_t(slot >> 2 * tile_bits_), at = std::uint32_t(slot & (tile_slots() - 1));
    const Tile t = tile(number);
    return {t.x << tile_bits_ | even_bits(at), t.y << tile_bits_ | even_bits(at >> 1)};
}

std::uint64_t SlotOrder::pixels_before(std::uint32_t number) const {
    const Tile t = tile(number);
    const std::uint64_t top = std::min(t.y << tile_bits_, height_),
                        rows = std::min(1u << tile_bits_, height_ - std::uint32_t(top));
    return top * width_ + std::min(t.x << tile_bits_, width_) * rows;
}

Lengths lengths_of(const Config& config) {
    const auto pipelines = std::uint64_t(config.pipelines), slots = std::uint64_t(1) << 2 * config.tile_bits;
    // Several pipelines take tiles at different speeds, so such a machine needs longer to settle.
    const std::uint64_t in_flight = std::max<std::uint64_t>(64, std::uint64_t(config.contexts)),
                        settle = pipelines == 1 ? 1 : 2;
    const auto tiles = [&](std::uint64_t pixels, std::uint64_t least) {
        return std::uint32_t(std::max(least, (pixels * pipelines + slots - 1) / slots));
    };
    return {tiles(8 * settle * in_flight, settle * pipelines), tiles(32 * in_flight, 2 * pipelines),
            tiles(4 * settle * in_flight, settle * pipelines)};
}

Parts parts_of(const Frame& frame, const Config& config) {
    Parts parts{SlotOrder(frame, config.tile_bits), lengths_of(config)};
    parts.count = std::max(1u, parts.order.tiles() / parts.lengths.part);
    return parts;
}

std::vector<Stratum> draw(const std::vector<std::uint64_t>& work, std::uint32_t strata, Rng& rng) {
    std::vector<std::uint32_t> parts(work.size() - 2);
    std::iota(parts.begin(), parts.end(), 1u);
    std::stable_sort(parts.begin(), parts.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return work[a] < work[b]; });
    std::uint64_t left = 0;
    for (const std::uint32_t part : parts) left += work[part];
    std::vector<Stratum> drawn;
    std::uint32_t at = 0;
    for (std::uint32_t s = 0; s < strata; ++s) {
        const std::uint32_t others = strata - s - 1;   // strata that still follow
        const std::uint64_t goal = left / (others + 1);
        std::uint32_t size = 0;
        std::uint64_t sum = 0;
        const auto room = std::uint32_t(parts.size()) - at - 3 * others;
        while (size < room && (others == 0 || size < 3 || 2 * sum + work[parts[at + size]] <= 2 * goal))
            sum += work[parts[at + size++]];
        const std::uint64_t a = below(rng, size), b = below(rng, size - 1);
        drawn.push_back({size, {parts[at + a], parts[at + (b < a ? b : b + 1)]}});
        at += size;
        left -= sum;
    }
    return drawn;
}

}   // namespace rayclock::sample
