#pragma once
// The kd-tree over the primitives of a scene on the lattice.
#include "model/engine/space_cells/cell.hpp"

namespace rayclock::kd {

/// Builds a tree whose planes lie across the axes, at both ends of the primitives (space_cells/build.hpp).
space_cells::CellPtr build(const std::vector<PrimData>& prims, const Config& config);
space_cells::CellPtr build(const space_cells::Pieces& pieces, const Config& config);

}   // namespace rayclock::kd
