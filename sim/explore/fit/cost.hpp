#pragma once
// What a configuration's formats cost in hardware, estimated: only to say which of two is smaller.
#include <cstdint>

#include "model/core/config.hpp"

namespace rayclock::fit {

/// Of one pipeline. An adder is one bit of a carry chain, about a LUT.
struct Cost {
    std::uint64_t multiplier_adders = 0;   ///< a times b bits: a * b
    std::uint64_t divider_adders = 0;      ///< a divisor of a bits and q bits of quotient: a * q
    std::uint64_t ray_bits = 0;            ///< memory: what the contexts keep
    std::uint64_t stack_bits = 0;          ///< of that, the stacks
    std::uint64_t cache_bits = 0;          ///< data and tags

    /// The order in which `fit` calls one configuration smaller: adders, and a memory bit for an eighth of
    /// one (a LUT of an ECP5 holds 16 bits of single-port memory, and these are read and written at once).
    std::uint64_t total() const { return multiplier_adders + divider_adders + (ray_bits + cache_bits) / 8; }
};
Cost cost_of(const Config& config);

}   // namespace rayclock::fit
