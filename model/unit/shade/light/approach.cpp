// Moves the origin of a distant ray to the lattice.
#include "model/unit/shade/light/approach.hpp"

#include <cstdlib>

namespace rayclock {

namespace {

Vec3l along(const Vec3l& p, const Vec3i& d, int shift) {
    Vec3l q{};
    for (std::size_t k = 0; k < 3; ++k) q[k] = p[k] + d[k] * (std::int64_t(1) << shift);
    return q;
}

/// True if a slab of the lattice lies ahead.
bool is_before(const Vec3l& q, const Vec3i& d, std::int64_t end) {
    for (std::size_t k = 0; k < 3; ++k)
        if (d[k] < 0 ? q[k] > end : q[k] < -end) return true;
    return false;
}

}   // namespace

std::optional<Vec3i> approach(const Vec3l& p, const Vec3i& d, const Config& c) {
    const std::int64_t end = lattice_end(c);
    Vec3l at = p;
    for (int step = approach_steps - 1; step >= 0; --step)
        if (const Vec3l next = along(at, d, c.approach_shift() + step); is_before(next, d, end)) at = next;
    at = along(at, d, c.approach_shift());
    Vec3i origin{};
    for (std::size_t k = 0; k < 3; ++k) {
        if (std::abs(at[k]) > end) return std::nullopt;
        origin[k] = std::int32_t(at[k]);
    }
    return origin;
}

}   // namespace rayclock
