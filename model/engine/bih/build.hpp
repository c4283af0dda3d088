#pragma once
// The bounding interval hierarchy over the primitives of a scene on the lattice.
#include "model/engine/space_cells/cell.hpp"

namespace rayclock::bih {

/// Builds a hierarchy that has every primitive in one leaf. The tree of boxes of structure=bvh decides which
/// primitives go together. For each node the builder takes the axis on which the two boxes are farthest
/// apart, or overlap least. The box with the smaller centre is the lower half. A pass from the leaves up
/// decides which nodes share a line (space_cells/treelets.hpp).
///
/// Infinite planes lie in a separate part next to the tree, which every ray visits.
space_cells::CellPtr build(const space_cells::Pieces& pieces, const Config& config);

}   // namespace rayclock::bih
