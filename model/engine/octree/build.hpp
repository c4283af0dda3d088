#pragma once
// The octree over the primitives of a scene on the lattice.
#include "model/engine/kd/cell.hpp"

namespace rayclock::octree {

/// The box of all primitives, halved on three axes at once where more than `leaf_size` of them lie, down to
/// a depth of `most_depth` (Meagher 1980; Glassner 1984, "Space subdivision for fast ray tracing"). Halves
/// meet at a lattice plane; an axis on which a cell is thinner than two steps is left as it is.
///
/// What straddles a plane is referenced from every leaf in which some of it lies, by exact clipping, and
/// references are bounded (kd/build.hpp), or it stays in the inner node (`straddlers`): then a node with
/// primitives of its own is walked in two parts that no plane divides, they and its octants.
kd::CellPtr build(const std::vector<PrimData>& prims, const Config& config);
kd::CellPtr build(const kd::Pieces& pieces, const Config& config);
constexpr int most_depth = 12;

}   // namespace rayclock::octree
