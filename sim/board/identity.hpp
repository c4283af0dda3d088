#pragma once
// The identity of a bitstream.
#include <cstdint>

#include "model/core/config.hpp"

namespace rayclock {

/// Returns the hash of a configuration that a bitstream carries. Two configurations with the same package of
/// the RTL have the same hash.
std::uint64_t config_hash(const Config& config);

}   // namespace rayclock
