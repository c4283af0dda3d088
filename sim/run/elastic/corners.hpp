#pragma once
// Requests for single units, with operands at the ends of their range.
#include <random>

#include "model/core/layout.hpp"
#include "model/machine/units.hpp"

namespace rayclock {

/// True if corner cases exist for a unit on this chip: for node units on a chip without instances, and for
/// tri on a chip without shading and instances.
bool has_corners(Unit unit, const Config& config);

/// Replaces operands of a request by values at the ends of their range, by zero, or by each other, each with
/// a probability of 1/4. The request of a node unit gets the origin or a corner of the recorded ray, and
/// another direction. Its node keeps the number and the kinds of its children. Then computes the answer with
/// the unit's pure function. Needs has_corners().
void to_corner(Unit unit, Words& request, Words& answer, const Config& config, std::mt19937_64& random);

}   // namespace rayclock
