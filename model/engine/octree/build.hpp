#pragma once
// The octree over the primitives of a scene on the lattice.
#include "model/engine/space_cells/cell.hpp"

namespace rayclock::octree {

/// Builds an octree: the box of all primitives, halved on all three axes where it holds more than `leaf_size`
/// of them, down to a depth of `max_depth` (Meagher 1980; Glassner 1984, "Space subdivision for fast ray
/// tracing"). Halves meet at a lattice plane. An axis on which a cell is thinner than two steps is not
/// halved.
///
/// A primitive that straddles a plane has a reference in every leaf that it reaches, by exact clipping, and
/// references are bounded (space_cells/build.hpp). With `straddlers` inner it stays in the inner node
/// instead. A node that holds primitives itself is walked in two parts that no plane divides: these
/// primitives and its octants.
space_cells::CellPtr build(const std::vector<PrimData>& prims, const Config& config);
space_cells::CellPtr build(const space_cells::Pieces& pieces, const Config& config);
constexpr int max_depth = 12;

}   // namespace rayclock::octree
