#pragma once
// The kd-tree over the primitives of a scene on the lattice.
#include "model/engine/cells/cell.hpp"

namespace rayclock::kd {

/// Builds a tree whose planes lie across the axes, at both ends of the primitives (cells/build.hpp).
cells::CellPtr build(const std::vector<PrimData>& prims, const Config& config);
cells::CellPtr build(const cells::Pieces& pieces, const Config& config);

}   // namespace rayclock::kd
