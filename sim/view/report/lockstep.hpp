#pragma once
#include <string>

#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// What a comparison of model and RTL found, for people: one line, and more if they differ.
std::string lockstep_lines(const LockstepResult& result);

}   // namespace rayclock
