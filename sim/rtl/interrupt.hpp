#pragma once

namespace rayclock {

/// Ctrl-C makes long runs stop with what they have, once catch_interrupts() was called. The second one ends
/// the program at once.
void catch_interrupts();
bool interrupted();

}   // namespace rayclock
