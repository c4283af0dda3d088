// Finds hits and directions in 256-bit integers.
#include "tests/support/geometry/exact.hpp"

namespace rayclock::test {

ExactHit ExactScene::closest(const Vec3i& o, const Vec3i& d) const {
    ExactHit best;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const auto hit = oracle::cross<Int, Int>(o, d, triangles_[i]);
        if (hit && (best.primitive == no_primitive || hit->num * best.den < best.num * hit->den))
            best = {std::uint32_t(i), hit->num, hit->den};
    }
    return best;
}

Vec3i exact_direction(const Frame& frame, int x, int y, const Config& config) {
    std::array<Int, 3> sum;
    for (std::size_t k = 0; k < 3; ++k)
        sum[k] = Int(frame.corner[k]) + x * Int(frame.right[k]) + y * Int(frame.down[k]);
    const Int unit = Int(2) << guard_bits, most = Int(1) << (config.dir_bits - 1);   // of twice the sum
    for (int shift = max_shift;; --shift) {
        std::array<Int, 3> twice;
        bool fits = true;
        for (std::size_t k = 0; k < 3; ++k) {
            twice[k] = sum[k] * (Int(2) << shift);
            fits = fits && twice[k] < most * unit && twice[k] >= -most * unit;
        }
        if (!fits && shift > 0) continue;
        Vec3i d{};
        for (std::size_t k = 0; k < 3; ++k) {
            Int whole = (twice[k] + unit / 2) / unit;   // rounds towards zero
            if (whole * unit > twice[k] + unit / 2) --whole;
            d[k] = std::min<Int>(whole, most - 1).convert_to<std::int32_t>();
        }
        return d;
    }
}

}   // namespace rayclock::test
