#pragma once
// Seeded random operands, many of them from the ends of their widths.
#include <algorithm>
#include <array>

#include "model/base/rng.hpp"
#include "model/core/frame.hpp"

namespace rayclock::torture {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : rng_(seed) {}
    int below(int n) { return rng_.below(n); }
    int between(int lo, int hi) { return lo + rng_.below(hi - lo + 1); }
    bool percent(int p) { return rng_.below(100) < p; }
    /// Returns a number in 0..2^bits: half of the draws are 0, 2^bits or one half.
    std::uint32_t share(int bits) {
        const std::uint32_t one = 1u << bits;
        switch (rng_.below(6)) {
            case 0: return 0;
            case 1: return one;
            case 2: return one / 2;
            default: return std::uint32_t(rng_.next() % (one + 1));
        }
    }
    std::array<std::uint32_t, 3> colour(int bits) { return {share(bits), share(bits), share(bits)}; }
    /// Returns a number in -most..most. A third of the draws are near an end, 0 or +-1.
    std::int32_t number(std::int32_t most) {
        const std::int32_t corners[] = {most, -most, most - 1, 1 - most, 0, 1, -1};
        if (rng_.below(3) == 0) return corners[rng_.below(7)];
        return between(-most, most);
    }
    /// Returns a signed number of `bits` bits. A third of the draws are near an end, or are 0 or +-1.
    std::int32_t signed_number(int bits) {
        const std::int32_t most = (1 << (bits - 1)) - 1;
        return percent(5) ? -most - 1 : number(most);
    }
    std::uint32_t bits() { return std::uint32_t(rng_.next() >> 32); }
    /// Returns dice that draw other numbers. These dice do not change.
    Dice branch() const {
        Rng seed = rng_;
        return Dice(~seed.next());
    }
    Vec3i point(std::int32_t most) { return {number(most), number(most), number(most)}; }
    /// Returns a point at most `reach` away on each axis, within -most..most.
    Vec3i near(const Vec3i& p, std::int32_t reach, std::int32_t most) {
        Vec3i q;
        for (std::size_t k = 0; k < 3; ++k) q[k] = std::clamp(p[k] + between(-reach, reach), -most, most);
        return q;
    }

private:
    Rng rng_;
};

inline std::int32_t max_of(int bits) { return (1 << (bits - 1)) - 1; }

}   // namespace rayclock::torture
