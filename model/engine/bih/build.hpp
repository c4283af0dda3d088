#pragma once
// The bounding interval hierarchy over the primitives of a scene on the lattice.
#include "model/engine/kd/cell.hpp"

namespace rayclock::bih {

/// Builds a hierarchy that has every primitive in one leaf. The tree of boxes of structure=bvh decides which
/// primitives go together. A pair of planes separates the two halves of a node: on the axis on which their
/// boxes are farthest apart or overlap least, the lower half is the one with the smaller centre. A pass from
/// the leaves up decides which nodes share a line (kd/treelets.hpp).
///
/// Infinite planes are walked next to the tree, in a part of their own.
kd::CellPtr build(const kd::Pieces& pieces, const Config& config);

}   // namespace rayclock::bih
