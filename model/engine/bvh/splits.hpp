#pragma once
// The binary tree over boxes, with spatial splits.
#include "model/layout/tree.hpp"
#include "model/core/config.hpp"

namespace rayclock {

/// As build_tree(), but where the boxes of both sides would overlap by more than 1e-5 of the root's surface,
/// the cell may be cut by a plane instead, of 15 on each axis, if that is cheaper by the same heuristic
/// (Stich, Friedrich and Dietrich 2009, "Spatial splits in bounding volume hierarchies"). What the plane cuts
/// is in both sides then, each with the box of its own part (kd/clip.hpp), unless it is cheaper to leave it
/// whole in one of them. So several leaves may be of one primitive; BinaryNode::left says of which.
///
/// References are bounded: every primitive brings most_split_references, which are given down to both sides
/// of a cut in proportion to what lies there. A cell that has not enough for a cut is divided as without
/// splits.
///
/// `boxes` are those of `prims`, in their order. A cell with a plane without end is not cut.
constexpr double most_split_references = 2;
BinaryTree build_split_tree(const std::vector<LatticeBox>& boxes, const std::vector<PrimData>& prims,
                            const Config& config);

}   // namespace rayclock
