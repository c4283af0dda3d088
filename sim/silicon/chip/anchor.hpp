#pragma once
// Improves the sites of multipliers and block memories in a placement. These sites lie in a few rows of a
// device. A placer spreads the cells over them before the surrounding logic has positions. In a full chip a
// cell can end a hundred tiles from everything that it is wired to. This step gives each cell a better one of
// the sites in use. A second placement that starts from these sites has shorter wires.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/silicon/chip/cells.hpp"

namespace rayclock::chip {

/// The sites of multipliers and block memories, by the cell's name: "X104/Y58/MULT18_0".
using Sites = std::map<std::string, std::string>;

/// Returns sites for all multipliers and block memories of placed cells. Cells of one kind exchange sites as
/// long as wires become shorter. The length of a net is half the perimeter of its bounding box.
Sites anchors(const std::vector<Cell>& cells);

/// Returns anchors() of the cells in a file written by nextpnr. Throws UserError if the file is incomplete.
Sites anchors_of(const std::filesystem::path& placed);

/// Copies a netlist of Yosys and adds the sites to these cells as attributes BEL, which bind nextpnr. Throws
/// UserError if the copy cannot be written, or if the netlist lacks a cell.
void write_anchored(const std::filesystem::path& netlist, const std::filesystem::path& to,
                    const Sites& sites);

/// Returns the sum of half perimeters over all nets, in tiles.
long long wire_length(const std::vector<Cell>& cells);

}   // namespace rayclock::chip
