// The dynamic program of collapse.hpp.
#include "model/engine/bvh/collapse.hpp"

#include <limits>

#include <tbb/parallel_for.h>

#include "model/engine/bvh/build.hpp"

namespace rayclock::bvh {

namespace {

constexpr float impossible = std::numeric_limits<float>::infinity();

}   // namespace

Collapse::Collapse(const BinaryTree& tree, const Config& config)
    : tree_(tree),
      width_(config.node_width),
      leaf_size_(config.leaf_size),
      counts_(tree.nodes.size()),
      left_(tree.nodes.size()),
      leaf_(tree.nodes.size()) {
    std::vector<std::size_t> levels;
    const std::vector<std::uint32_t> order = top_down(tree, &levels);
    std::vector<Cost> costs(tree.nodes.size());
    for (std::size_t level = levels.size() - 1; level-- > 0;)
        tbb::parallel_for(tbb::blocked_range<std::size_t>(levels[level], levels[level + 1], 512),
                          [&](const auto& range) {
                              for (std::size_t i = range.begin(); i < range.end(); ++i)
                                  solve(order[i], costs);
                          });
}

void Collapse::solve(std::uint32_t index, std::vector<Cost>& costs) {
    const BinaryNode& node = tree_.nodes[index];
    const auto area = float(node.box.area());
    Cost& cost = costs[index];
    if (node.is_leaf()) {
        counts_[index] = 1;
        leaf_[index] = 1;
        cost.fill(area * triangle_cost);
        return;
    }
    const int count = std::min(counts_[node.left] + counts_[node.right], leaf_size_ + 1);
    counts_[index] = std::uint8_t(count);
    const Cost &left = costs[node.left], &right = costs[node.right];
    std::array<float, max_width + 1> shared{};   // [i]: cost of both sides together as at most i children
    for (int i = 2; i <= width_; ++i) {
        shared[std::size_t(i)] = impossible;
        for (int k = 1; k < i; ++k) {
            const float sum = left[std::size_t(k)] + right[std::size_t(i - k)];
            if (sum >= shared[std::size_t(i)]) continue;
            shared[std::size_t(i)] = sum;
            left_[index][std::size_t(i)] = std::uint8_t(k);
        }
    }
    const float as_leaf = count <= leaf_size_ ? area * triangle_cost * float(count) : impossible;
    const float as_inner = area * node_cost + shared[std::size_t(width_)];
    leaf_[index] = as_leaf <= as_inner;
    cost[1] = std::min(as_leaf, as_inner);
    for (std::size_t i = 2; i < std::size_t(width_); ++i) {
        cost[i] = std::min(shared[i], cost[i - 1]);
        if (cost[i - 1] <= shared[i]) left_[index][i] = 0;
    }
}

void Collapse::gather(std::uint32_t index, int most, std::vector<WideChild>& out) const {
    const BinaryNode& node = tree_.nodes[index];
    if (!node.is_leaf())
        while (most > 1 && left_[index][std::size_t(most)] == 0) --most;
    if (most == 1 || node.is_leaf()) {
        out.push_back({index, leaf_[index] != 0});
        return;
    }
    const int k = left_[index][std::size_t(most)];
    gather(node.left, k, out);
    gather(node.right, most - k, out);
}

void Collapse::children(std::uint32_t index, std::vector<WideChild>& out) const {
    out.clear();
    // Only the root can be a leaf by itself and still be a node.
    if (leaf_[index])
        out.push_back({index, true});
    else
        gather(index, width_, out);
}

void Collapse::boxes(std::uint32_t index, std::vector<std::uint32_t>& out) const {
    const BinaryNode& node = tree_.nodes[index];
    if (node.is_leaf()) return out.push_back(node.left);
    boxes(node.left, out);
    boxes(node.right, out);
}

}   // namespace rayclock::bvh
