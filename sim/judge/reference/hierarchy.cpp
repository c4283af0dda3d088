// The binary build and its collapse to four children per node.
#include "sim/judge/reference/hierarchy.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include <tbb/parallel_invoke.h>

#include "sim/judge/reference/split.hpp"

namespace rayclock {
namespace {

// Deeper nodes use split_by_count(): at most 32 more levels for 2^32 boxes.
constexpr int max_area_depth = 64;
constexpr std::size_t parallel_from = 4096;   // boxes; smaller subtrees do not justify a task

/// A binary node. The left child of node i is i + 1. The subtree over n boxes owns 2n - 1 entries. So the
/// entries of both halves are known before either is built, and both may be built at the same time.
struct BinaryNode {
    RefExtent bounds;
    std::uint32_t first = 0, count = 0;
    std::uint32_t right = 0;   // 0: a leaf
};

struct BinaryBuilder {
    std::span<RefBox> boxes;
    BinaryNode* nodes;

    void build(std::uint32_t at, std::uint32_t first, std::uint32_t count, int depth) const {
        const std::span<RefBox> part = boxes.subspan(first, count);
        const RefSummary summary = summarise(part);
        std::size_t left = 0;
        if (count > 1)
            left = depth < max_area_depth ? split_by_area(part, summary) : deep_split(part, summary);
        const auto n = static_cast<std::uint32_t>(left);
        nodes[at] = {summary.bounds, first, count, n == 0 ? 0 : at + 2 * n};
        if (n == 0) return;
        const auto build_left = [&] { build(at + 1, first, n, depth + 1); };
        const auto build_right = [&] { build(at + 2 * n, first + n, count - n, depth + 1); };
        if (count < parallel_from) {
            build_left();
            build_right();
        } else {
            tbb::parallel_invoke(build_left, build_right);
        }
    }

    static std::size_t deep_split(std::span<RefBox> part, const RefSummary& summary) {
        return part.size() <= ref_max_leaf ? 0 : split_by_count(part, summary);
    }
};

/// Turns the binary tree into nodes of four children, depth first.
struct Collapser {
    std::span<const RefBox> boxes;
    const BinaryNode* binary;
    RefHierarchy& out;

    /// Collects the children of a wide node. It starts with the two children of the binary node, and replaces
    /// the largest by its own children until there are four.
    int gather(std::uint32_t root, std::array<std::uint32_t, 4>& children) const {
        if (binary[root].right == 0) {
            children[0] = root;
            return 1;
        }
        children = {root + 1, binary[root].right, 0, 0};
        int count = 2;
        while (count < 4) {
            int largest = -1;
            for (int i = 0; i < count; ++i) {
                const BinaryNode& node = binary[children[i]];
                if (node.right == 0) continue;
                if (largest < 0 || node.bounds.area() > binary[children[largest]].bounds.area()) largest = i;
            }
            if (largest < 0) break;
            const std::uint32_t opened = children[largest];
            children[largest] = opened + 1;
            children[count++] = binary[opened].right;
        }
        return count;
    }

    std::uint32_t emit(std::uint32_t root) {
        std::array<std::uint32_t, 4> children{};
        const int count = gather(root, children);
        const auto at = static_cast<std::uint32_t>(out.nodes.size());
        out.nodes.push_back(empty_node());
        for (int i = 0; i < count; ++i) {
            const BinaryNode& child = binary[children[i]];
            for (int a = 0; a < 3; ++a) {
                out.nodes[at].plane[2 * a][i] = child.bounds.lo[a];
                out.nodes[at].plane[2 * a + 1][i] = child.bounds.hi[a];
            }
            if (child.right == 0) {
                out.nodes[at].child[i] = static_cast<std::uint32_t>(out.order.size() / ref_block_size);
                out.nodes[at].blocks[i] = emit_leaf(child);
            } else {
                const std::uint32_t inner = emit(children[i]);
                out.nodes[at].child[i] = inner;
                out.nodes[at].blocks[i] = 0;
            }
        }
        return at;
    }

    std::uint32_t emit_leaf(const BinaryNode& leaf) {
        const std::uint32_t blocks = (leaf.count + ref_block_size - 1) / ref_block_size;
        for (std::uint32_t i = 0; i < blocks * ref_block_size; ++i)
            out.order.push_back(boxes[leaf.first + std::min(i, leaf.count - 1)].primitive);
        return blocks;
    }

    static RefNode empty_node() {
        RefNode node{};
        for (int p = 0; p < 6; ++p)
            for (int i = 0; i < 4; ++i) node.plane[p][i] = p % 2 == 0 ? RefExtent::inf : -RefExtent::inf;
        std::fill_n(node.blocks, 4, 1u);
        return node;
    }
};

}   // namespace

RefHierarchy build_hierarchy(std::vector<RefBox>& boxes) {
    RefHierarchy out;
    if (boxes.empty()) return out;
    const auto count = static_cast<std::uint32_t>(boxes.size());
    const auto binary = std::make_unique_for_overwrite<BinaryNode[]>(2 * boxes.size());
    BinaryBuilder{boxes, binary.get()}.build(0, 0, count, 0);
    out.order.reserve(boxes.size() + boxes.size() / 2);
    out.nodes.reserve(boxes.size() / 3 + 1);
    Collapser{boxes, binary.get(), out}.emit(0);
    return out;
}

}   // namespace rayclock
