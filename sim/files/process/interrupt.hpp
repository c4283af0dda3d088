#pragma once
// Ctrl-C and SIGTERM: a long run that polls interrupted() stops and keeps its results.

namespace rayclock {

/// Installs the signal handlers. If nothing calls interrupted() within 0.5 s, or at the second signal, the
/// program ends at once. It then removes its temporary files (sim/files/scratch.hpp).
void catch_interrupts();
/// Returns true after the first Ctrl-C or SIGTERM. The caller must then stop soon.
bool interrupted();

}   // namespace rayclock
