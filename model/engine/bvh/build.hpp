#pragma once
// Builds and improves binary trees of boxes.
#include <cstdint>
#include <vector>

#include "model/layout/tree.hpp"

namespace rayclock::bvh {

/// Builds a tree top-down by the surface area heuristic (Wald 2007, "On fast construction of SAH-based
/// bounding volume hierarchies"). It bins large ranges and tries every position in small ones. It splits at
/// the object median where all centres coincide, and below a depth that no reasonable scene reaches. `boxes`
/// must not be empty.
BinaryTree build_tree(const std::vector<LatticeBox>& boxes);

/// Moves subtrees to where they add the least area (Bittner, Hapala, Havran 2013; batches as in Meister and
/// Bittner 2018, "Parallel reinsertion for bounding volume hierarchy optimization").
void optimise_tree(BinaryTree& tree);

/// Returns every node once, parents before children, level by level. `levels`, if given, receives the start
/// of each level, and the end.
std::vector<std::uint32_t> top_down(const BinaryTree& tree, std::vector<std::size_t>* levels = nullptr);

}   // namespace rayclock::bvh
