#pragma once
// How far a stress run has come, in a file.
#include <functional>
#include <string_view>

#include "sim/explore/stress/run.hpp"

namespace rayclock::stress {

/// The rays that each cell has had after so many batches.
using RaysOfCells = std::function<std::vector<std::uint64_t>(std::uint64_t batches)>;

/// Reads the counts of all cells; returns how many batches they hold. Throws UserError if the file is no
/// state, is of another plan, or holds numbers that this plan cannot have given.
std::uint64_t read_state(const Plan& plan, std::vector<Cell>& cells, std::uint64_t batches_in_all,
                         const RaysOfCells& rays_after);
/// The same of a text that has been read.
std::uint64_t parse_state(const Plan& plan, std::string_view text, std::vector<Cell>& cells,
                          std::uint64_t batches_in_all, const RaysOfCells& rays_after);
void write_state(const Plan& plan, const std::vector<Cell>& cells, std::uint64_t batches);

}   // namespace rayclock::stress
