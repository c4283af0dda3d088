#pragma once
// The binary tree over boxes, with spatial splits.
#include "model/core/config.hpp"
#include "model/layout/tree.hpp"

namespace rayclock::bvh {

/// Builds a tree as build_tree() does. Where the boxes of both sides would overlap by more than 1e-5 of the
/// root's surface, a plane may cut the cell instead. It tries 15 planes on each axis and needs a lower cost
/// by the same heuristic (Stich, Friedrich and Dietrich 2009, "Spatial splits in bounding volume
/// hierarchies"). A primitive that the plane cuts goes to both sides, each time with the box of its own part
/// (space_cells/clip.hpp). If it is cheaper, it stays whole in one side. So several leaves may hold one
/// primitive; BinaryNode::left gives its number.
///
/// References are bounded. Every primitive brings max_split_references, and a cut distributes them to both
/// sides in proportion to their items. A cell with too few for a cut is divided as without splits.
///
/// `boxes` are those of `prims`, in the same order. A cell with an infinite plane is not cut.
constexpr double max_split_references = 2;
BinaryTree build_split_tree(const std::vector<LatticeBox>& boxes, const std::vector<PrimData>& prims,
                            const Config& config);

}   // namespace rayclock::bvh
