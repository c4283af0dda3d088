#pragma once
// Collapses the binary tree to wide nodes: chooses the subtrees that become children of a node, and those
// that become leaves.
//
// The choice is SAH-optimal by dynamic programming (Ylitie, Karras, Laine 2017, "Efficient incoherent ray
// traversal on GPUs through compressed wide BVHs", section 3.1). cost(n, i) is the least cost of the subtree
// n as at most i children of one node.
#include <cstdint>
#include <vector>

#include "model/layout/tree.hpp"

namespace rayclock::bvh {

// Costs of a node visit and of a triangle test, as weights of the SAH. Measured on the seven SPD scenes with
// leaves of 2: from 1 down to 0.6 visits fall by up to 1.6 %. Below that tests rise faster (gears 4.15 to
// 4.43 per ray at 0.1). With leaves of one triangle the weight has no effect.
constexpr float node_cost = 1, triangle_cost = 0.6f;

/// A child of a wide node: a subtree of the binary tree.
struct WideChild {
    std::uint32_t node = 0;
    bool leaf = false;
};

/// Chooses children and leaves for every node of a binary tree. The tree must outlive it.
class Collapse {
public:
    Collapse(const BinaryTree& tree, const Config& config);

    /// Returns in `out` the children, at most node_width, of the wide node over binary node `node`, left to
    /// right.
    void children(std::uint32_t node, std::vector<WideChild>& out) const;
    /// Appends to `out` the numbers of the boxes (as given to the builder) in the leaf over binary node
    /// `node`, left to right.
    void boxes(std::uint32_t node, std::vector<std::uint32_t>& out) const;

private:
    using Cost = std::array<float, max_width>;   ///< [i]: cost as at most i children; [0] is unused

    void solve(std::uint32_t node, std::vector<Cost>& costs);
    void gather(std::uint32_t node, int most, std::vector<WideChild>& out) const;

    const BinaryTree& tree_;
    int width_, leaf_size_;
    std::vector<std::uint8_t> counts_;   // triangles, at most leaf_size + 1
    /// [i]: number of children, out of i, for the left side. 0: one child fewer costs no more.
    std::vector<std::array<std::uint8_t, max_width + 1>> left_;
    std::vector<std::uint8_t> leaf_;   // 1: best as a leaf if it is one child
};

}   // namespace rayclock::bvh
