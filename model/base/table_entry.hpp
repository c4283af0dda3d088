#pragma once
#include <cstdint>

namespace rayclock {

/// Of a table of a function: a value, and how far the next one lies from it, for linear interpolation.
struct TableEntry {
    std::uint32_t value = 0, step = 0;
};

}   // namespace rayclock
