// The samples of a pixel.
#include "model/scene/whitted.hpp"

#include <array>

namespace rayclock {

namespace {

/// Prime to n * n. For an even n the first four cells lie in at least three quarters of the pixel.
constexpr std::array<std::uint32_t, max_aa + 1> stride{0, 1, 3, 4, 7, 7, 13, 18, 29};

/// Jenkins 1997, "one at a time", over three words: only additions, shifts and exclusive ors.
std::uint32_t hash(std::uint32_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t s) {
    std::uint32_t h = seed;
    for (const std::uint32_t word : {x, y, s}) {
        h += word;
        h += h << 10;
        h ^= h >> 6;
    }
    h += h << 3;
    h ^= h >> 11;
    return h + (h << 15);
}

}   // namespace

std::uint32_t sample_stride(int n) { return stride[std::size_t(n)]; }

SampleOffset sample_offset(std::uint32_t x, std::uint32_t y, std::uint32_t s, int n, bool jitter,
                           std::uint32_t seed) {
    const auto side = std::uint32_t(n), cell = s * stride[side] % (side * side);
    const std::uint32_t random = jitter ? hash(seed, x, y, s) : 128u << 8 | 128u;
    const std::uint32_t right = ((cell % side) << 8 | (random & 255)) / side,
                        down = ((cell / side) << 8 | (random >> 8 & 255)) / side;
    return {std::int32_t(right) - 128, std::int32_t(down) - 128};
}

}   // namespace rayclock
