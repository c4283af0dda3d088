#include "tests/system/exact.hpp"

namespace rayclock::test {

ExactHit ExactScene::closest(const Vec3i& o, const Vec3i& d) const {
    ExactHit best;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const auto hit = oracle::cross<Int, Int>(o, d, triangles_[i]);
        if (hit && (best.primitive == no_primitive || hit->num * best.den < best.num * hit->den)) best = {std::uint32_t(i), hit->num, hit->den};
    }
    return best;
}

Vec3i exact_direction(const Frame& frame, int x, int y) {
    Vec3i d{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Int twice = 2 * (Int(frame.corner[k]) + x * Int(frame.right[k]) + y * Int(frame.down[k])), unit = Int(2) << guard_bits;
        Int whole = (twice + unit / 2) / unit;   // towards zero
        if (whole * unit > twice + unit / 2) --whole;
        d[k] = whole.convert_to<std::int32_t>();
    }
    return d;
}

} // namespace rayclock::test
