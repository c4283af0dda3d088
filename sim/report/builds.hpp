#pragma once
// What people see while RTL is built, which takes longer than anything else that the program does.

namespace rayclock {

/// From now on builds of RTL are told on standard error: a line that moves on a terminal, otherwise one at
/// the beginning.
void show_builds();

}   // namespace rayclock
