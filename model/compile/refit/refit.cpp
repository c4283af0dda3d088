// Refits and rebuilds a tree of boxes.
#include "model/compile/refit/refit.hpp"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "model/compile/compile.hpp"
#include "model/compile/emit.hpp"
#include "model/engine/bvh/collapse.hpp"
#include "model/engine/bvh/decode.hpp"
#include "model/engine/bvh/encode.hpp"
#include "model/layout/words.hpp"

namespace rayclock {

bool Refit::follow(std::vector<PrimData> prims, double rebuild) {
    const bool is_first = nodes_.empty();
    prims_ = std::move(prims);
    boxes_ = boxes_of(prims_, config_);
    if (!is_first) {
        fit();
        if (cost() <= rebuild * built_cost_) return false;
    }
    build();
    return true;
}

void Refit::build() {
    const MemoryImage image = compile_triangles(prims_, config_, name_);
    report_ = image.report;
    nodes_.clear(), inner_.clear(), leaves_.clear(), content_.clear();
    read(image);
    fit();
    built_cost_ = cost();
}

/// Reads a compiled tree as it lies in memory, without its boxes.
void Refit::read(const MemoryImage& image) {
    nodes_.reserve(report_.nodes), leaves_.reserve(report_.leaves), content_.reserve(report_.references);
    nodes_.push_back({});
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const Node from = bvh::read_node(image, nodes_[n].line, config_);
        WideNode node = nodes_[n];
        node.base = from.base;
        node.first_inner = std::uint32_t(inner_.size()), node.first_leaf = std::uint32_t(leaves_.size());
        for (std::size_t i = 0; i < std::size_t(config_.node_width); ++i) {
            if (from.kind[i] == 1) {
                inner_.push_back(std::uint32_t(nodes_.size()));
                nodes_.push_back({from.base + node.inner++, 0, 0, 0, 0, 0, {}});
            } else if (from.kind[i] > 1) {
                leaves_.push_back({std::uint32_t(content_.size()), from.kind[i] - 1});
                content_.resize(content_.size() + from.kind[i] - 1);
                ++node.leaves;
            }
        }
        if (node.leaves > 0)
            for (std::uint32_t k = leaves_[node.first_leaf].first, at = 2 * (node.base + node.inner);
                 k < content_.size(); ++k, ++at)
                content_[k] = read_primitive(image, at, config_).prim;
        nodes_[n] = node;
    }
}

LatticeBox Refit::box_of(const Leaf& leaf) const {
    LatticeBox box;
    for (std::uint32_t i = 0; i < leaf.count; ++i) box.add(boxes_[content_[leaf.first + i]]);
    return box;
}

/// Recomputes the boxes from the leaves up. All children of a node come after it.
void Refit::fit() {
    for (std::size_t n = nodes_.size(); n-- > 0;) {
        WideNode& node = nodes_[n];
        node.box = {};
        for (std::uint32_t i = 0; i < node.leaves; ++i) node.box.add(box_of(leaves_[node.first_leaf + i]));
        for (std::uint32_t i = 0; i < node.inner; ++i) node.box.add(nodes_[inner_[node.first_inner + i]].box);
    }
}

/// Returns the expected cost of a ray that meets the root's box: every node visit and every primitive test,
/// in proportion to the surfaces of their boxes.
double Refit::cost() const {
    double sum = 0;
    for (const WideNode& node : nodes_) sum += bvh::node_cost * node.box.area();
    for (const Leaf& leaf : leaves_) sum += double(bvh::triangle_cost) * leaf.count * box_of(leaf).area();
    return sum / std::max(1.0, nodes_[0].box.area());
}

void Refit::write(std::uint32_t root, bool in_mesh, std::uint32_t* words, std::uint32_t lines) const {
    std::fill_n(words, std::size_t(lines) * words_per_line, 0u);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, nodes_.size(), 512), [&](const auto& range) {
        for (std::size_t n = range.begin(); n < range.end(); ++n) write_node(nodes_[n], root, in_mesh, words);
    });
}

void Refit::write_node(const WideNode& node, std::uint32_t root, bool in_mesh, std::uint32_t* words) const {
    thread_local Words scratch;
    std::array<bvh::NodeChild, max_width> children;
    for (std::uint32_t i = 0; i < node.inner; ++i)
        children[i] = {nodes_[inner_[node.first_inner + i]].box, 0};
    std::size_t half = 2 * std::size_t(node.base + node.inner);
    for (std::uint32_t i = 0; i < node.leaves; ++i) {
        const Leaf& leaf = leaves_[node.first_leaf + i];
        children[node.inner + i] = {box_of(leaf), leaf.count};
        for (std::uint32_t k = 0; k < leaf.count; ++k, ++half)
            write_payload(prims_[content_[leaf.first + k]], config_, &words[half * words_per_half], scratch);
    }
    const std::span all(children.data(), node.inner + node.leaves);
    std::uint32_t* const at = &words[std::size_t(node.line) * words_per_line];
    write_payload(bvh::encode_node(all, node.base + root, config_), config_, at, scratch);
    if (in_mesh) set_line_kind(at, LineKind::mesh_node);
}

// Each node except the root has at least two children. So over n primitives there are at most n - 1 nodes, or
// one if n is 1. A node takes a line, and its leaves' c primitives take (c + 1) / 2 lines.
std::uint64_t Refit::max_lines(std::uint64_t prims) {
    const std::uint64_t nodes = std::max<std::uint64_t>(1, prims - 1);
    return nodes + (prims + nodes) / 2;
}

}   // namespace rayclock
