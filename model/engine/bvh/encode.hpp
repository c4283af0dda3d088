#pragma once
// Quantises the child boxes of a node.
#include <span>

#include "model/engine/bvh/node.hpp"
#include "model/layout/tree.hpp"

namespace rayclock::bvh {

/// A child of a node to be written: its exact box, and its number of triangles (0: an inner child). Inner
/// children come first.
struct NodeChild {
    LatticeBox box;
    std::uint32_t triangles = 0;
};

/// Returns the node that holds the children, quantised outward. `org` is the minimum corner of all boxes.
/// Each axis has the finest exponent that reaches the maximum corner; lo is rounded down and hi up. So a
/// dequantised box contains the exact one.
Node encode_node(std::span<const NodeChild> children, std::uint32_t base, const Config& config);

/// Returns plane `k` of a node's child along `axis`, in lattice steps.
inline std::int64_t dequantised(const Node& node, std::uint32_t k, std::size_t axis) {
    return node.org[axis] + (std::int64_t(k) << node.exp[axis]);
}

}   // namespace rayclock::bvh
