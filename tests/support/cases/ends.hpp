#pragma once
// Small operands and operands at the ends of their widths.
#include "tests/support/cases/draw.hpp"

namespace rayclock::test {

/// Draws a signed number of n bits, at most two away from an end or from zero.
inline std::int64_t at_an_end(Draw& draw, int n) {
    const std::int64_t most = std::int64_t((std::uint64_t(1) << (n - 1)) - 1), least = -most - 1;
    const std::int64_t ends[] = {least, 0, 0, most};
    return std::clamp<std::int64_t>(ends[draw.below(4)] + draw.between(-2, 2), least, most);
}
inline Vec3i vector_at_ends(Draw& draw, int n) {
    Vec3i v;
    for (auto& x : v) x = std::int32_t(at_an_end(draw, n));
    return v;
}

}   // namespace rayclock::test
