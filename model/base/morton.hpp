#pragma once
// Morton order: the bits of x and y alternate, x in the lowest.
#include <cstdint>

namespace rayclock {

/// Returns bits 0, 2, 4, ... of a number below 2^12, next to each other: x of a Morton number. even_bits(m >>
/// 1) is y.
constexpr std::uint32_t even_bits(std::uint32_t m) {
    m &= 0x555;
    m = (m | m >> 1) & 0x333;
    m = (m | m >> 2) & 0xf0f;
    return (m | m >> 4) & 0x3f;
}

}   // namespace rayclock
