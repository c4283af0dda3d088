#pragma once
// Places of all rays in a machine that is stuck.
#include <string>

namespace rayclock {

class Machine;

/// Returns the place of every ray of a machine that no longer moves, a line each, for the watchdog.
std::string describe_stuck_rays(const Machine& machine);

}   // namespace rayclock
