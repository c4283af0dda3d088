#pragma once
// The entry type of the tables that shade and globe interpolate.
#include <cstdint>

namespace rayclock {

/// One entry of a function's table: a value, and the step to the next value for linear interpolation.
struct TableEntry {
    std::uint32_t value = 0, step = 0;
};

}   // namespace rayclock
