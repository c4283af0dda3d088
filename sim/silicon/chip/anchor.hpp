#pragma once
// Multipliers and block memories have their sites in a few rows of a device, and a placer spreads them over
// these before it knows where the logic around them will lie: in a full chip one may come to lie a hundred
// tiles from all that it is wired to. Here a placement is looked at, and each gets a better one of the sites
// that were used. A second placement that begins with them there has shorter wires.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/silicon/chip/cells.hpp"

namespace rayclock::chip {

/// Of multipliers and block memories, by the cell's name: "X104/Y58/MULT18_0".
using Sites = std::map<std::string, std::string>;

/// Sites of all multipliers and block memories of placed cells: exchanged among those of one kind as
/// long as that makes wires shorter, by half the perimeter of a net's bounding box.
Sites anchors(const std::vector<Cell>& cells);

/// The same of the cells in a file that nextpnr wrote. Throws UserError if it is not whole.
Sites anchors_of(const std::filesystem::path& placed);

/// Copies a netlist of Yosys; these cells of it get their sites as attributes BEL, which nextpnr obeys.
/// Throws UserError if it cannot be written, or a cell is not in it.
void write_anchored(const std::filesystem::path& netlist, const std::filesystem::path& to,
                    const Sites& sites);

/// Sum of all nets' half perimeters, in tiles.
long long wire_length(const std::vector<Cell>& cells);

}   // namespace rayclock::chip
