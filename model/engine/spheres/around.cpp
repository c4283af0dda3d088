// Computes the globes of a tree's children in parallel.
#include "model/engine/spheres/around.hpp"

#include <tbb/parallel_for.h>

namespace rayclock::spheres {

namespace {

/// All primitives in the order of the tree's leaves, and the range of each node among them.
struct Order {
    explicit Order(const BinaryTree& tree) : first(tree.nodes.size()), count(tree.nodes.size()) {
        std::vector<std::uint32_t> pending{tree.root}, visited;
        while (!pending.empty()) {
            const std::uint32_t n = pending.back();
            pending.pop_back();
            visited.push_back(n);
            const BinaryNode& node = tree.nodes[n];
            first[n] = std::uint32_t(prims.size());
            if (node.is_leaf())
                prims.push_back(node.left), count[n] = 1;
            else
                pending.push_back(node.right), pending.push_back(node.left);
        }
        for (std::size_t i = visited.size(); i-- > 0;)
            if (const BinaryNode& node = tree.nodes[visited[i]]; !node.is_leaf())
                count[visited[i]] = count[node.left] + count[node.right];
    }
    std::vector<std::uint32_t> prims, first, count;
};

std::vector<std::uint32_t> children_of(const BinaryTree& tree, const bvh::Collapse& collapse) {
    std::vector<std::uint32_t> all, pending{tree.root};
    std::vector<bvh::WideChild> found;
    while (!pending.empty()) {
        const std::uint32_t node = pending.back();
        pending.pop_back();
        found.clear();
        collapse.children(node, found);
        for (const bvh::WideChild& child : found) {
            all.push_back(child.node);
            if (!child.leaf) pending.push_back(child.node);
        }
    }
    return all;
}

}   // namespace

GlobesAround::GlobesAround(const BinaryTree& tree, const bvh::Collapse& collapse, const AddBeads& add)
    : globes_(tree.nodes.size()) {
    const Order order(tree);
    const std::vector<std::uint32_t> children = children_of(tree, collapse);
    tbb::parallel_for(std::size_t(0), children.size(), [&](std::size_t i) {
        const std::uint32_t node = children[i];
        std::vector<Bead> beads;
        beads.reserve(3 * std::size_t(order.count[node]));
        for (std::uint32_t n = 0; n < order.count[node]; ++n) add(order.prims[order.first[node] + n], beads);
        globes_[node] = enclose(beads);
    });
}

}   // namespace rayclock::spheres
