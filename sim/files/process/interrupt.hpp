#pragma once

namespace rayclock {

/// Ctrl-C and SIGTERM stop long runs with what they have. If nobody asks interrupted() soon, or at the second
/// one, the program ends at once and removes what lies under temporary names (sim/files/scratch.hpp).
void catch_interrupts();
bool interrupted();

}   // namespace rayclock
