#pragma once
// How far a stress run has come, in a file.
#include "sim/stress/run.hpp"

namespace rayclock::stress {

/// Reads the counts of all cells; returns how many batches they hold. Throws UserError if the file is no state, or of another plan.
std::uint64_t read_state(const Plan& plan, std::vector<Cell>& cells);
void write_state(const Plan& plan, const std::vector<Cell>& cells, std::uint64_t batches);

} // namespace rayclock::stress
