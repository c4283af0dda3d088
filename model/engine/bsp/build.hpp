#pragma once
// The tree of planes in any direction over the primitives of a scene on the lattice.
#include "model/engine/space_cells/cell.hpp"

namespace rayclock::bsp {

/// Builds a tree whose planes may lie in any direction (facets.hpp, space_cells/build.hpp). `prims`, in the
/// order of the pieces, offer these planes. Without prims all planes lie across the axes.
space_cells::CellPtr build(const space_cells::Pieces& pieces, const std::vector<PrimData>& prims,
                           const Config& config);

}   // namespace rayclock::bsp
