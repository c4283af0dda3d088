// Building the tree from the top by medians.
#include "sim/judge/oracle/tree.hpp"

#include <numeric>

namespace rayclock::oracle {

Tree::Tree(const std::vector<Extent>& boxes, int margin) : order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(boxes.size());
    if (!boxes.empty()) root_ = build(boxes, margin, 0, std::uint32_t(boxes.size()));
}

/// Builds a node over a part of order_ and returns its number.
std::uint32_t Tree::build(const std::vector<Extent>& boxes, int margin, std::uint32_t first,
                          std::uint32_t count) {
    const auto bounds = [&](std::uint32_t from, std::uint32_t n) {
        Extent all = boxes[order_[from]];
        for (std::uint32_t i = from + 1; i < from + n; ++i) {
            all.add(boxes[order_[i]].lo);
            all.add(boxes[order_[i]].hi);
        }
        return all;
    };
    // Puts the lower half of a part first, along the part's longest axis. The box number breaks ties.
    const auto halve = [&](std::uint32_t from, std::uint32_t n) {
        const std::size_t axis = bounds(from, n).longest();
        const auto middle = [&](std::uint32_t i) {
            return std::pair(std::int64_t(boxes[i].lo[axis]) + boxes[i].hi[axis], i);
        };
        const auto begin = order_.begin() + from;
        std::nth_element(begin, begin + n / 2, begin + n,
                         [&](std::uint32_t i, std::uint32_t j) { return middle(i) < middle(j); });
        return n / 2;
    };
    // Bounds of the four parts. Some parts may be empty.
    std::array<std::uint32_t, 5> cut{0, 0, count, count, count};
    if (count > 1) {
        cut[2] = halve(first, count);
        cut[1] = cut[2] > 1 ? halve(first, cut[2]) : 0;
        cut[3] = count - cut[2] > 1 ? cut[2] + halve(first + cut[2], count - cut[2]) : cut[2];
    }
    const auto number = std::uint32_t(nodes_.size());
    nodes_.emplace_back();
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t from = first + cut[i], n = cut[i + 1] - cut[i];
        std::uint32_t child = tree::none;
        if (n > 0) {
            const Extent box = bounds(from, n);
            for (std::size_t k = 0; k < 3; ++k) {
                nodes_[number].boxes.centre[k][i] = double(box.lo[k]) + box.hi[k];
                nodes_[number].boxes.width[k][i] = double(box.hi[k]) - box.lo[k] + 2 * margin;
            }
            nodes_[number].there |= 1u << i;
            child = n == 1 ? from | tree::leaf : build(boxes, margin, from, n);
        }
        nodes_[number].child[i] = child;
    }
    return number;
}

}   // namespace rayclock::oracle
