#pragma once
// The progress of a stress run, stored in a file.
#include <functional>
#include <string_view>

#include "sim/explore/stress/stress_batches.hpp"

namespace rayclock::stress {

/// Returns the rays of each cell after a number of batches.
using RaysOfCells = std::function<std::vector<std::uint64_t>(std::uint64_t batches)>;

/// Reads the counts of all cells and returns the number of batches. Throws UserError if the file is not a
/// state, belongs to another plan, or holds counts that this plan cannot give.
std::uint64_t read_state(const Plan& plan, std::vector<Cell>& cells, std::uint64_t batches_in_all,
                         const RaysOfCells& rays_after);
/// Reads a state from text.
std::uint64_t parse_state(const Plan& plan, std::string_view text, std::vector<Cell>& cells,
                          std::uint64_t batches_in_all, const RaysOfCells& rays_after);
void write_state(const Plan& plan, const std::vector<Cell>& cells, std::uint64_t batches);

}   // namespace rayclock::stress
