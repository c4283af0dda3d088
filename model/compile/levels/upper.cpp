// Writes the scene's tree of two levels.
#include "model/compile/levels/upper.hpp"

#include <algorithm>

#include "model/compile/levels/upper_lines.hpp"
#include "model/compile/textures.hpp"
#include "model/engine/bvh/build.hpp"
#include "model/engine/bvh/collapse.hpp"
#include "model/engine/bvh/encode.hpp"
#include "model/engine/engines.hpp"
#include "model/engine/spheres/around.hpp"
#include "model/engine/spheres/encode.hpp"

namespace rayclock {
namespace {

/// Returns the configuration of a tree with one entry per leaf.
Config single(Config config) {
    config.leaf_size = 1;
    return config;
}

/// Writes a node over subtrees as boxes.
class UpperBoxes {
public:
    UpperBoxes(const std::vector<UpperEntry>&, const BinaryTree& tree, const bvh::Collapse&,
               const Config& config)
        : tree_(tree), config_(config) {}
    Node node(const std::vector<bvh::WideChild>& found, std::uint32_t base) const {
        std::array<bvh::NodeChild, max_width> children;
        for (std::size_t i = 0; i < found.size(); ++i) children[i] = {tree_.nodes[found[i].node].box, 0};
        return bvh::encode_node(std::span(children).first(found.size()), base, config_);
    }

private:
    const BinaryTree& tree_;
    const Config& config_;
};

/// Writes a node over subtrees as globes, which hold the corners of boxes and so the boxes.
class UpperGlobes {
public:
    UpperGlobes(const std::vector<UpperEntry>& entries, const BinaryTree& tree, const bvh::Collapse& collapse,
                const Config& config)
        : config_(config), around_(tree, collapse, [&](std::uint32_t i, std::vector<spheres::Bead>& beads) {
              const LatticeBox& box = entries[i].map->box;
              for (int corner = 0; corner < 8; ++corner)
                  beads.push_back({{corner & 1 ? box.hi[0] : box.lo[0], corner & 2 ? box.hi[1] : box.lo[1],
                                    corner & 4 ? box.hi[2] : box.lo[2]},
                                   0});
          }) {}
    GlobeNode node(const std::vector<bvh::WideChild>& found, std::uint32_t base) const {
        std::array<spheres::GlobeChild, max_width> children;
        for (std::size_t i = 0; i < found.size(); ++i) children[i] = {around_[found[i].node], 0};
        return spheres::encode_globes(std::span(children).first(found.size()), base, config_);
    }

private:
    const Config& config_;
    spheres::GlobesAround around_;
};

/// `As` is UpperBoxes or UpperGlobes.
template <class As> class TreeWriter {
public:
    TreeWriter(const BinaryTree& tree, UpperLines& lines, UpperTotals& totals, const As& as,
               const bvh::Collapse& collapse)
        : tree_(tree), lines_(lines), totals_(totals), as_(as), collapse_(collapse) {}

    /// Writes a subtree. Returns the number of sibling groups that a ray may have to keep below the node.
    int write(std::uint32_t node, std::uint32_t line, int depth) {
        std::vector<bvh::WideChild> found;
        collapse_.children(node, found);
        const std::uint32_t base = lines_.take(found.size());
        lines_.write(as_.node(found, base), line);
        ++totals_.report.nodes;
        int need = 0;
        for (std::uint32_t i = 0; i < found.size(); ++i)
            need = std::max(need, found[i].leaf ? totals_.place(entry_of(found[i].node), base + i, depth)
                                                : write(found[i].node, base + i, depth + 1));
        return need + (found.size() >= 2);
    }

private:
    std::uint32_t entry_of(std::uint32_t node) const {
        std::vector<std::uint32_t> one;
        collapse_.boxes(node, one);
        return one[0];
    }

    const BinaryTree& tree_;
    UpperLines& lines_;
    UpperTotals& totals_;
    const As& as_;
    const bvh::Collapse& collapse_;
};

template <class As> UpperReport write_tree(const std::vector<UpperEntry>& entries, const BinaryTree& tree,
                                           UpperLines& lines, std::uint32_t root,
                                           std::vector<PlacedEntry>& placed) {
    const bvh::Collapse collapse(tree, single(lines.config()));
    const As as(entries, tree, collapse, lines.config());
    UpperTotals totals{entries, placed};
    totals.report.stack_need = TreeWriter(tree, lines, totals, as, collapse).write(tree.root, root, 1);
    return totals.report;
}

}   // namespace

UpperReport write_upper(const std::vector<UpperEntry>& entries, std::uint32_t line, bool thorough,
                        const Config& config, const std::string& name, std::vector<std::uint32_t>& words,
                        std::vector<PlacedEntry>& placed) {
    std::vector<LatticeBox> boxes;
    boxes.reserve(entries.size());
    for (const UpperEntry& entry : entries) boxes.push_back(entry.map->box);
    placed.clear();
    UpperLines lines(line, config, name, words);
    const auto written = [&] {
        if (has_cells(config)) return write_upper_cells(entries, boxes, lines, line, placed);
        BinaryTree tree = bvh::build_tree(boxes);
        if (thorough) bvh::optimise_tree(tree);
        return config.engine() == Structure::spheres
                   ? write_tree<UpperGlobes>(entries, tree, lines, line, placed)
                   : write_tree<UpperBoxes>(entries, tree, lines, line, placed);
    };
    UpperReport report = written();
    report.lines = lines.taken();
    return report;
}

void write_entries(const std::vector<UpperEntry>& entries, const std::vector<PlacedEntry>& placed,
                   const Config& config, std::vector<std::uint32_t>& words) {
    constexpr std::uint32_t none = ~0u;
    std::vector<std::uint32_t> here(entries.size(), none);
    Words scratch;
    for (const PlacedEntry& at : placed) {
        const UpperEntry& entry = entries[at.entry];
        if (here[at.entry] == none) here[at.entry] = at.line;
        std::uint32_t* const line = &words[std::size_t(at.line) * words_per_line];
        std::fill_n(line, words_per_line, 0u);
        const std::uint32_t surfaces = entry.first_surface_line & ((1u << config.addr_bits) - 1);
        write_payload(
            Placement{entry.first, entry.root, here[at.entry], surfaces, entry.material, entry.map->is_same,
                      config.has_textures() ? texel_scale_of(entry.map->a, config) : 0, entry.map->a,
                      entry.map->b},
            config, line, scratch);
        set_line_kind(line, LineKind::placement);
    }
}

}   // namespace rayclock
