// Sums and names for the costs of a frame.
#include "sim/view/observe/costs.hpp"

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

}   // namespace rayclock
