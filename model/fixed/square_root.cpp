// Integer square root, bit by bit.
#include "model/fixed/square_root.hpp"

#include <bit>

namespace rayclock {

/// Decides the root's bits from the top.
std::uint64_t square_root(Unsigned x) {
    const auto high = std::uint64_t(x >> 64);
    const int length = high != 0 ? 64 + int(std::bit_width(high)) : int(std::bit_width(std::uint64_t(x)));
    if (length == 0) return 0;
    std::uint64_t root = 0;
    for (std::uint64_t bit = std::uint64_t(1) << (length - 1) / 2; bit != 0; bit >>= 1)
        if (Unsigned(root | bit) * (root | bit) <= x) root |= bit;
    return root;
}

}   // namespace rayclock
