#pragma once
// Seeded random operands. Half of them are corner cases, where comparisons and overflow go wrong.
#include <algorithm>
#include <array>
#include <random>

#include "model/core/payloads.hpp"

namespace rayclock::test {

class Draw {
public:
    explicit Draw(unsigned seed) : rng_(seed) {}

    std::uint64_t bits(int n) { return n == 0 ? 0 : rng_() >> (64 - n); }
    int below(int n) { return int(rng_() % std::uint64_t(n)); }
    int between(int lo, int hi) { return lo + below(hi - lo + 1); }
    bool percent(int p) { return below(100) < p; }
    bool coin() { return bits(1) != 0; }

    /// Draws a signed number of n bits.
    std::int64_t number(int n) {
        const std::int64_t most = std::int64_t((std::uint64_t(1) << (n - 1)) - 1), least = -most - 1;
        std::int64_t value = std::int64_t(bits(n) << (64 - n)) >> (64 - n);
        if (coin()) {
            const std::int64_t power = std::int64_t(1) << below(n - 1);
            const std::int64_t corners[] = {0,        1,     -1,     least,     most, least + 1,
                                            most - 1, power, -power, power - 1, last_};
            value = corners[below(int(std::size(corners)))];
            if (value < least || value > most) value = 0;
        }
        return last_ = value;
    }
    /// Draws an unsigned number of n bits.
    std::uint64_t natural(int n) {
        const std::uint64_t most = n == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << n) - 1;
        if (coin()) return bits(n);
        const std::uint64_t corners[] = {0, 1, most, most - 1, std::uint64_t(1) << below(n), natural_};
        return natural_ = std::min(corners[below(int(std::size(corners)))], most);
    }
    /// Draws three signed numbers of n bits. In one of four vectors a pair is equal, in one of eight opposite
    /// if that fits.
    Vec3i vector(int n) {
        Vec3i v;
        for (auto& x : v) x = std::int32_t(number(n));
        if (below(4) == 0) v[std::size_t(below(3))] = v[std::size_t(below(3))];
        return v;
    }
    /// Draws a lattice point near p, within n bits.
    Vec3i near(const Vec3i& p, int reach, int n) {
        const int most = (1 << (n - 1)) - 1;
        Vec3i q;
        for (std::size_t k = 0; k < 3; ++k) q[k] = std::clamp(p[k] + between(-reach, reach), -most - 1, most);
        return q;
    }

private:
    std::mt19937_64 rng_;
    std::int64_t last_ = 0;
    std::uint64_t natural_ = 0;
};

/// Fills every field of a payload with random bits, for tests of units that only pass it on.
class FillVisitor {
public:
    explicit FillVisitor(Draw& draw) : draw_(draw) {}
    template <class T> void operator()(const char*, T& value, int width) { value = any<T>(width); }
    template <class T, std::size_t n>
    void operator()(const char*, std::array<T, n>& value, int width, int count) {
        for (std::size_t i = 0; i < std::size_t(count); ++i) value[i] = any<T>(width);
    }

private:
    template <class T> T any(int width) {
        if constexpr (std::is_signed_v<T> || sizeof(T) > 8)
            return T(draw_.number(std::min(width, 63)));
        else
            return T(draw_.natural(width));
    }
    Draw& draw_;
};
template <class P> P random_payload(Draw& draw, const Config& config) {
    P payload;
    FillVisitor fill{draw};
    payload.fields(fill, config);
    return payload;
}

}   // namespace rayclock::test
