#pragma once
// Requests for tri with operands at the ends of their range.
#include <random>

#include "model/core/payloads.hpp"

namespace rayclock {

/// True if corner cases exist for tri on this chip: a chip without shading and instances.
inline bool has_tri_corners(const Config& config) { return !config.shading && !config.has_instances(); }

/// Replaces components of ray and triangle by values at the ends of their range, by zero, or by each other.
/// Each component is replaced with a probability of 1/4.
void to_corner(TriReq& request, const Config& config, std::mt19937_64& random);

}   // namespace rayclock
