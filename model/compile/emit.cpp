// Writes trees of boxes and globes as memory lines.
#include "model/compile/emit.hpp"

#include "model/base/error.hpp"
#include "model/engine/bvh/encode.hpp"
#include "model/engine/spheres/around.hpp"
#include "model/engine/spheres/encode.hpp"
#include "model/layout/node_statistics.hpp"
#include "model/layout/words.hpp"

namespace rayclock {

namespace {

/// Collects the children of a node and writes it as boxes.
class Boxes {
public:
    Boxes(const BinaryTree& tree, const Config& config) : tree_(tree), config_(config) {}
    void clear() { children_.clear(); }
    void add(const bvh::WideChild& child, std::uint32_t primitives) {
        children_.push_back({tree_.nodes[child.node].box, primitives});
    }
    Node node(std::uint32_t base) const { return bvh::encode_node(children_, base, config_); }

private:
    const BinaryTree& tree_;
    const Config& config_;
    std::vector<bvh::NodeChild> children_;
};

/// Collects the children of a node and writes it as globes.
class Globes {
public:
    Globes(const spheres::GlobesAround& around, const Config& config) : around_(around), config_(config) {}
    void clear() { children_.clear(); }
    void add(const bvh::WideChild& child, std::uint32_t primitives) {
        children_.push_back({around_[child.node], primitives});
    }
    GlobeNode node(std::uint32_t base) const { return spheres::encode_globes(children_, base, config_); }

private:
    const spheres::GlobesAround& around_;
    const Config& config_;
    std::vector<spheres::GlobeChild> children_;
};

template <class Children> class TreeEmitter {
public:
    TreeEmitter(const bvh::Collapse& collapse, std::uint32_t root, Children children,
                const std::vector<PrimData>& triangles, const Config& config, const std::string& name,
                MemoryImage& image)
        : root_(root),
          triangles_(triangles),
          config_(config),
          collapse_(collapse),
          children_(std::move(children)),
          name_(name),
          image_(image) {}

    void run() {
        image_.words.assign(words_per_line, 0);
        pending_.push_back({root_, 0, 0});
        // Depth-first: last in, first out, with inner children pushed from the last to the first.
        while (!pending_.empty()) {
            const Pending next = pending_.back();
            pending_.pop_back();
            emit(next);
        }
        nodes_written_.fill_report(image_);
    }

private:
    struct Pending {
        std::uint32_t node = 0, line = 0, parent = 0;
    };

    void emit(const Pending& at) {
        collapse_.children(at.node, found_);
        const auto leaves = std::stable_partition(found_.begin(), found_.end(),
                                                  [](const bvh::WideChild& c) { return !c.leaf; });
        const auto inner = std::uint32_t(leaves - found_.begin());
        children_.clear();
        content_.clear();
        for (const bvh::WideChild& child : found_) {
            const std::size_t before = content_.size();
            if (child.leaf) {
                collapse_.boxes(child.node, content_);
                once(before);
            }
            children_.add(child, std::uint32_t(content_.size() - before));
        }
        const std::size_t base = image_.words.size() / words_per_line;
        const std::size_t lines = base + inner + (content_.size() + 1) / 2;
        check_lines(lines, config_, name_);
        image_.words.resize(lines * words_per_line, 0);
        write_payload(children_.node(std::uint32_t(base)), config_, &image_.words[at.line * words_per_line],
                      scratch_);
        for (std::size_t i = 0; i < content_.size(); ++i)
            write_payload(triangles_[content_[i]], config_,
                          &image_.words[(2 * (base + inner) + i) * words_per_half], scratch_);

        const std::uint32_t id = nodes_written_.add(at.parent, inner);
        image_.report.leaves += found_.size() - inner;
        image_.report.references += content_.size();
        for (std::uint32_t i = inner; i-- > 0;)
            pending_.push_back({found_[i].node, std::uint32_t(base + i), id});
    }

    /// Removes repeated primitives from the leaf that starts at `first`: parts of one primitive may meet in a
    /// leaf.
    void once(std::size_t first) {
        std::size_t end = first;
        for (std::size_t i = first; i < content_.size(); ++i) {
            const auto from = content_.begin() + std::ptrdiff_t(first),
                       to = content_.begin() + std::ptrdiff_t(end);
            if (std::find(from, to, content_[i]) == to) content_[end++] = content_[i];
        }
        content_.resize(end);
    }

    std::uint32_t root_;
    const std::vector<PrimData>& triangles_;
    const Config& config_;
    const bvh::Collapse& collapse_;
    Children children_;
    const std::string& name_;
    MemoryImage& image_;
    std::vector<Pending> pending_;
    NodeStatistics nodes_written_;
    std::vector<bvh::WideChild> found_;
    std::vector<std::uint32_t> content_;   // triangles of the node's leaves
    Words scratch_;
};

}   // namespace

void check_lines(std::uint64_t lines, const Config& config, const std::string& name) {
    if (lines <= std::uint64_t(1) << config.addr_bits) return;
    throw UserError(name + ": the memory image needs more than 2^" + std::to_string(config.addr_bits) +
                    " lines of 64 bytes, all that the machine can address; " +
                    (config.addr_bits < max_addr_bits
                         ? "--set addr_bits=" + std::to_string(max_addr_bits) + " is the most there is"
                         : "a smaller scene is needed"));
}

void emit_boxes(const BinaryTree& tree, const std::vector<PrimData>& triangles, const Config& config,
                const std::string& name, MemoryImage& image) {
    const bvh::Collapse collapse(tree, config);
    TreeEmitter(collapse, tree.root, Boxes(tree, config), triangles, config, name, image).run();
}

void emit_globes(const BinaryTree& tree, const std::vector<PrimData>& prims, const Config& config,
                 const std::string& name, MemoryImage& image) {
    const bvh::Collapse collapse(tree, config);
    const spheres::GlobesAround around(tree, collapse,
                                       [&](std::uint32_t i, std::vector<spheres::Bead>& beads) {
                                           spheres::add_beads(prims[i], config, beads);
                                       });
    TreeEmitter(collapse, tree.root, Globes(around, config), prims, config, name, image).run();
}

}   // namespace rayclock
