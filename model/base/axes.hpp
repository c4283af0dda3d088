#pragma once
// Vectors whose components are made alike.
#include <array>
#include <cstddef>

namespace rayclock {

/// {of(0), of(1), of(2)}, worked out in this order.
template <class Of> constexpr auto by_axis(const Of& of) {
    return std::array{of(std::size_t(0)), of(std::size_t(1)), of(std::size_t(2))};
}

}   // namespace rayclock
