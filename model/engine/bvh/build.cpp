// Builds the binary tree of boxes top-down, on all cores.
#include "model/engine/bvh/build.hpp"

#include <tbb/parallel_invoke.h>

#include "model/engine/bvh/divide.hpp"

namespace rayclock::bvh {

namespace {

class Builder {
public:
    Builder(std::vector<BoxItem>& items, std::vector<BinaryNode>& nodes) : items_(items), nodes_(nodes) {}

    /// Builds the subtree over n items in the 2n - 1 places from `at`. The places are known in advance, so
    /// both halves may be built at the same time.
    void build(std::size_t at, std::size_t first, std::size_t count, int depth) {
        const std::span<BoxItem> part = std::span{items_}.subspan(first, count);
        BinaryNode& node = nodes_[at];
        LatticeBox centres;
        for (const BoxItem& item : part) {
            node.box.add(item.box);
            centres.add(Vec3i{item.box.centre(0), item.box.centre(1), item.box.centre(2)});
        }
        if (count == 1) {
            node.left = part[0].index;
            return;
        }
        const std::size_t n = divide(part, centres, depth);
        node.left = std::uint32_t(at + 1);
        node.right = std::uint32_t(at + 2 * n);
        const auto left = [&] { build(at + 1, first, n, depth + 1); };
        const auto right = [&] { build(at + 2 * n, first + n, count - n, depth + 1); };
        if (count < parallel_from) {
            left();
            right();
        } else {
            tbb::parallel_invoke(left, right);
        }
    }

private:
    std::vector<BoxItem>& items_;
    std::vector<BinaryNode>& nodes_;
};

}   // namespace

BinaryTree build_tree(const std::vector<LatticeBox>& boxes) {
    std::vector<BoxItem> items(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) items[i] = {boxes[i], std::uint32_t(i)};
    BinaryTree tree;
    tree.nodes.resize(2 * boxes.size() - 1);
    Builder{items, tree.nodes}.build(0, 0, boxes.size(), 0);
    return tree;
}

std::vector<std::uint32_t> top_down(const BinaryTree& tree, std::vector<std::size_t>* levels) {
    std::vector<std::uint32_t> order;
    order.reserve(tree.nodes.size());
    order.push_back(tree.root);
    if (levels) levels->assign(1, 0);
    for (std::size_t begin = 0; begin < order.size();) {
        const std::size_t end = order.size();
        for (; begin < end; ++begin) {
            const BinaryNode& node = tree.nodes[order[begin]];
            if (node.is_leaf()) continue;
            order.push_back(node.left);
            order.push_back(node.right);
        }
        if (levels) levels->push_back(end);
    }
    return order;
}

}   // namespace rayclock::bvh
