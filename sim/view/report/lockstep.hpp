#pragma once
// The result of lockstep as text.
#include <string>

#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// Returns the result of a comparison of model and RTL as text: one line if they agree, more if they differ.
std::string lockstep_lines(const LockstepResult& result);

/// Returns the first difference as text.
std::string divergence_lines(const Divergence& divergence);

}   // namespace rayclock
