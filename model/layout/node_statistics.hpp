#pragma once
// Records the nodes that a compiler has written, for the figures of its report.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/layout/memory_image.hpp"

namespace rayclock {

/// The nodes of a tree in the order of their writing: children after their parents.
class NodeStatistics {
public:
    /// Adds a node below `parent`, with `inner` children that are nodes, and returns its number. The first
    /// node is the root.
    std::uint32_t add(std::uint32_t parent, std::uint32_t inner) {
        const auto id = std::uint32_t(nodes_.size());
        nodes_.push_back({parent, inner, id == 0 ? 1 : nodes_[parent].depth + 1});
        return id;
    }

    /// Sets the report's depth, stack_need, nodes and bytes.
    void fill_report(MemoryImage& image) {
        for (std::size_t i = nodes_.size(); i-- > 0;) {
            Node& node = nodes_[i];
            node.need += node.inner >= 2;   // the siblings wait on the stack while a ray walks one child
            image.report.depth = std::max(image.report.depth, node.depth);
            if (i > 0) nodes_[node.parent].need = std::max(nodes_[node.parent].need, node.need);
        }
        image.report.stack_need = nodes_[0].need;
        image.report.nodes = nodes_.size();
        image.report.bytes = image.words.size() * sizeof(std::uint32_t);
    }

private:
    struct Node {
        std::uint32_t parent = 0, inner = 0;
        int depth = 1, need = 0;
    };
    std::vector<Node> nodes_;
};

}   // namespace rayclock
