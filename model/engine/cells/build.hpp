#pragma once
// Builds trees of cells top-down by the surface area heuristic.
#include <functional>

#include "model/engine/cells/split.hpp"

namespace rayclock::cells {

/// Replaces `best` by any cheaper cut of a cell. Several threads call it.
using ChooseCut = std::function<void(const Items& items, const Region& region, Split& best)>;

/// Builds a tree by the surface area heuristic with perfect splits (Wald and Havran 2006, "On building fast
/// kd-trees for ray tracing, and on doing that in O(N log N)"). `choose` picks the planes. Each cell uses the
/// primitives' clipped bounds, and planes at both ends of every primitive. A cut costs 8, a test 20, and a
/// plane that cuts off empty space is a tenth cheaper. More than 16 primitives count as fewer tests
/// (split.hpp), since they will be cut again. A level costs O(n), and the tree O(n log n).
///
/// The builder cuts deeper than is useful. A pass from the leaves up then decides which cuts remain
/// (treelets.hpp).
///
/// Config::references bounds the references. Every primitive brings that many, and a cut distributes them in
/// proportion to the parts' items. A cell with too few for a cut remains a leaf. No cell is cut below a depth
/// of 8 + 1.3 log2 n, at most 34.
///
/// The cell of a treelet is the box in its line, so no plane is spent on the space around it.
///
/// Infinite planes fill all of space. They are walked next to the tree, in a separate part.
CellPtr build(const Pieces& pieces, const Config& config, const ChooseCut& choose);

}   // namespace rayclock::cells
