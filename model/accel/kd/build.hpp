#pragma once
// The kd-tree over the primitives of a scene on the lattice.
#include <memory>
#include <string>
#include <vector>

#include "model/accel/kd/clip.hpp"

namespace rayclock::kd {

/// A cell of space: cut by a plane, not cut but walked in two parts (no_axis), or a leaf.
struct Cell {
    std::uint32_t axis = no_axis;   ///< if there are parts
    std::int32_t at = 0;
    LatticeBox bounds;   ///< of what is in it; inverted if nothing is, or it has no end
    std::unique_ptr<Cell> lower, upper;
    std::vector<std::uint32_t> prims;   ///< of a leaf: which of those given to the builder
    bool is_leaf() const { return !lower; }
};

/// Surface area heuristic with perfect splits (Wald and Havran 2006, "On building fast kd-trees for ray
/// tracing, and on doing that in O(N log N)"): of each cell the primitives' clipped bounds; a visit of a cell
/// costs 15, a test 20, and a plane that cuts off empty space is a fifth cheaper. Where there are many
/// primitives, 64 planes of each axis are tried, and the ends of all; where there are
/// few, at both ends of every primitive. So a level costs O(n), or O(n log few), and all of it O(n log n).
///
/// References are bounded: every primitive brings `most_references`, which are given down to both sides of a
/// plane in proportion to what lies there. A cell that has not enough for a cut remains a leaf. Nor is a cell
/// cut below a depth of 8 + 1.3 log2 n, at most 34.
///
/// The cell of a treelet is the box that its line has, so that no plane is spent on the space around it.
///
/// Planes without end are in all of space: they are walked beside the tree, in a part of their own.
std::unique_ptr<Cell> build(const std::vector<PrimData>& prims, const Config& config);
constexpr double most_references = 8;

}   // namespace rayclock::kd
