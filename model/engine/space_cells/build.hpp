#pragma once
// Builds trees of cells top-down by the surface area heuristic.
#include <functional>

#include "model/engine/space_cells/split.hpp"

namespace rayclock::space_cells {

/// Replaces `best` by any cheaper cut of a cell. Several threads call it.
using ChooseCut = std::function<void(const Items& items, const Region& region, Split& best)>;

/// Builds a tree by the surface area heuristic with perfect splits (Wald and Havran 2006, "On building fast
/// kd-trees for ray tracing, and on doing that in O(N log N)"). `choose` picks the planes. Each cell uses the
/// primitives' clipped bounds, and planes at both ends of every primitive. A cut costs 8, a test 20, and a
/// plane that cuts off empty space costs 10 % less. More than 16 primitives count as fewer tests (split.hpp),
/// because they will be cut again. A level takes O(n) time, and the tree O(n log n).
///
/// The builder cuts deeper than is useful. A pass from the leaves up then decides which cuts remain
/// (treelets.hpp).
///
/// Config::references limits the references: the tree may have that many for each primitive. A cut divides
/// its cell's references between the two parts, in proportion to their items. A cell with too few references
/// for a cut remains a leaf. No cell is cut below a depth of 8 + 1.3 log2 n, at most 34.
///
/// A treelet's line holds the box of its contents, so no plane has to cut off the space around them.
///
/// Infinite planes fill all of space. They lie in a separate part next to the tree.
CellPtr build(const Pieces& pieces, const Config& config, const ChooseCut& choose);

}   // namespace rayclock::space_cells
