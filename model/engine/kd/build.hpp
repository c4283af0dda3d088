#pragma once
// The kd-tree over the primitives of a scene on the lattice.
#include "model/engine/kd/cell.hpp"

namespace rayclock::kd {

/// Surface area heuristic with perfect splits (Wald and Havran 2006, "On building fast kd-trees for ray
/// tracing, and on doing that in O(N log N)"): of each cell the primitives' clipped bounds, and planes at
/// both ends of every primitive. A cut costs 8, a test 20, and a plane that cuts off empty space is a tenth
/// cheaper. More than 16 primitives count as fewer tests than they are (split.hpp), since they will be cut
/// again. A level costs O(n), and all of it O(n log n).
///
/// So the tree is deeper than it is good, and what of it is built is decided from the leaves up
/// (treelets.hpp).
///
/// References are bounded by Config::references: every primitive brings so many, which are given down to all
/// parts of a cell in proportion to what lies there. A cell that has not enough for a cut remains a leaf. No
/// cell is cut below a depth of 8 + 1.3 log2 n, at most 34.
///
/// The cell of a treelet is the box that its line has, so that no plane is spent on the space around it.
///
/// Planes without end are in all of space: they are walked beside the tree, in a part of their own.
CellPtr build(const std::vector<PrimData>& prims, const Config& config);
/// Of any pieces. Planes in any direction are offered by `prims`, in the same order, or by nothing if there
/// are none.
CellPtr build(const Pieces& pieces, const std::vector<PrimData>& prims, const Config& config);

}   // namespace rayclock::kd
