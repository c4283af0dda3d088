// Sums and names for the costs of a frame.
#include "sim/view/observe/costs.hpp"

#include <algorithm>

namespace rayclock {

const char* place_name(std::size_t place) {
    return place == memory_place ? unit_infos[index(Unit::memory)].name : unit_infos[place].name;
}

std::uint64_t PurposeCost::cycles() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t c : places) sum += c;
    return sum;
}
std::uint64_t PurposeCost::all_misses() const {
    std::uint64_t sum = 0;
    for (std::size_t c = 0; c < ray_caches; ++c) sum += misses[c] + merges[c];
    return sum;
}

FrameCosts::Sums FrameCosts::total() const {
    Sums s;
    for (const PixelCost& p : pixels) {
        s.rays += p.rays, s.visits += p.visits, s.tests += p.tests;
        s.misses += p.misses, s.bytes += p.bytes, s.cycles += p.cycles;
    }
    return s;
}

PixelRect FrameCosts::pixels_in(std::uint64_t first, std::uint64_t last) const {
    std::uint32_t x0 = width, y0 = height, x1 = 0, y1 = 0;   // x1 and y1 exclusive
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const PixelCost& pixel = pixels[std::size_t(y) * width + x];
            // A pixel leaves in cycle pixel.first + pixel.cycles.
            const bool is_in = pixel.first < last && pixel.first + std::uint64_t(pixel.cycles) >= first;
            if (pixel.rays == 0 || !is_in) continue;
            x0 = std::min(x0, x), x1 = std::max(x1, x + 1);
            y0 = std::min(y0, y), y1 = std::max(y1, y + 1);
        }
    if (x1 == 0) return {0, 0, {0, 0}};
    return {int(x0), int(y0), {int(x1 - x0), int(y1 - y0)}};
}

}   // namespace rayclock
