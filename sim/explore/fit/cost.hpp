#pragma once
// Estimates the hardware cost of a configuration's formats, to compare two configurations.
#include <cstdint>

#include "model/core/config.hpp"

namespace rayclock::fit {

/// The cost of one pipeline. An adder is one bit of a carry chain, about a LUT.
struct Cost {
    std::uint64_t multiplier_adders = 0;   ///< a times b bits: a * b
    std::uint64_t divider_adders = 0;      ///< a divisor of a bits and q bits of quotient: a * q
    std::uint64_t ray_bits = 0;            ///< memory of the contexts
    std::uint64_t stack_bits = 0;          ///< the stacks, a part of ray_bits
    std::uint64_t cache_bits = 0;          ///< data and tags

    /// The number by which `fit` compares configurations, in adders. A memory bit counts an eighth of an
    /// adder: a LUT of an ECP5 holds 16 bits of single-port memory, and these memories are read and written
    /// in one cycle.
    std::uint64_t total() const { return multiplier_adders + divider_adders + (ray_bits + cache_bits) / 8; }
};
Cost cost_of(const Config& config);

}   // namespace rayclock::fit
