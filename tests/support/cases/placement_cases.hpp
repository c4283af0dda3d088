#pragma once
// Random maps of instances. Each row's absolute values sum to at most 1, so points stay within the lattice.
#include "tests/support/cases/draw.hpp"

namespace rayclock::test {

/// Draws a row of a map whose absolute values sum to at most 1, and often exactly to 1. Includes 1 itself and
/// the smallest step.
inline std::array<std::int32_t, 3> row_of(Draw& draw, int frac) {
    const std::int64_t one = std::int64_t(1) << frac;
    std::array<std::int64_t, 3> part{};
    if (draw.below(4) == 0) {
        part[std::size_t(draw.below(3))] = one;
    } else {
        std::int64_t left = draw.coin() ? one : std::int64_t(draw.natural(frac));
        for (std::size_t k = 0; k < 3; ++k) {
            part[k] = k == 2 && draw.coin() ? left : std::int64_t(draw.natural(frac)) % (left + 1);
            left -= part[k];
        }
    }
    std::array<std::int32_t, 3> row{};
    const std::size_t from = std::size_t(draw.below(3));
    for (std::size_t k = 0; k < 3; ++k)
        row[k] = std::int32_t(draw.coin() ? part[(k + from) % 3] : -part[(k + from) % 3]);
    return row;
}

/// Draws an instance whose map keeps every point of the lattice within the lattice.
inline Placement random_placement(Draw& draw, const Config& c) {
    Placement p;
    const std::int64_t one = std::int64_t(1) << c.map_frac(),
                       most = (std::int64_t(1) << (c.coord_bits - 1)) - 1;
    p.here = std::uint32_t(std::max<std::uint64_t>(draw.natural(c.addr_bits), 1));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = row_of(draw, c.map_frac());
        std::int64_t left = one;
        for (std::size_t k = 0; k < 3; ++k) p.a[3 * i + k] = row[k], left -= std::abs(std::int64_t(row[k]));
        p.b[i] = std::clamp(draw.number(c.coord_bits + c.map_frac()), -most * left, most * left);
    }
    return p;
}

}   // namespace rayclock::test
