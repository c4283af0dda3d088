#pragma once
// Builds vectors component by component.
#include <array>
#include <cstddef>

namespace rayclock {

/// Returns {of(0), of(1), of(2)}, evaluated in this order.
template <class Of> constexpr auto by_axis(const Of& of) {
    return std::array{of(std::size_t(0)), of(std::size_t(1)), of(std::size_t(2))};
}

}   // namespace rayclock
