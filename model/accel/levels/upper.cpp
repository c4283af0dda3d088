#include "model/accel/levels/upper.hpp"

#include <algorithm>

#include "model/accel/collapse.hpp"
#include "model/accel/emit.hpp"
#include "model/accel/encode.hpp"

namespace rayclock {
namespace {

class UpperWriter {
public:
    UpperWriter(const std::vector<UpperEntry>& entries, BinaryTree tree, const Config& config,
                const std::string& name, std::vector<std::uint32_t>& words,
                std::vector<std::uint32_t>& placed)
        : entries_(entries),
          tree_(std::move(tree)),
          collapse_(tree_, single(config)),
          config_(config),
          name_(name),
          words_(words),
          placed_(placed) {}

    UpperReport run(std::uint32_t line) {
        next_ = line + 1;
        make_room();
        report_.stack_need = write_node(tree_.root, line, 1);
        return report_;
    }

private:
    static Config single(Config config) {
        config.leaf_size = 1;
        return config;
    }

    void make_room() {
        check_lines(next_, config_, name_);
        if (words_.size() < std::size_t(next_) * words_per_line)
            words_.resize(std::size_t(next_) * words_per_line, 0);
    }

    /// Returns how many groups of siblings a ray may have to keep below the node.
    int write_node(std::uint32_t node, std::uint32_t line, int depth) {
        std::vector<WideChild> found;
        collapse_.children(node, found);
        std::array<NodeChild, max_width> children;
        for (std::size_t i = 0; i < found.size(); ++i) children[i] = {tree_.nodes[found[i].node].box, 0};
        const std::uint32_t base = next_;
        next_ += std::uint32_t(found.size());
        make_room();
        std::uint32_t* const at = &words_[std::size_t(line) * words_per_line];
        std::fill_n(at, words_per_line, 0u);
        write_payload(encode_node(std::span(children).first(found.size()), base, config_), config_, at,
                      scratch_);
        ++report_.nodes;
        int need = 0;
        for (std::uint32_t i = 0; i < found.size(); ++i)
            need = std::max(need, found[i].leaf ? place(found[i].node, base + i, depth)
                                                : write_node(found[i].node, base + i, depth + 1));
        return need + (found.size() >= 2);
    }

    int place(std::uint32_t node, std::uint32_t line, int depth) {
        std::vector<std::uint32_t> one;
        collapse_.boxes(node, one);
        placed_[one[0]] = line;
        report_.depth = std::max(report_.depth, depth + 1 + entries_[one[0]].depth);
        ++report_.leaves;
        return entries_[one[0]].stack_need;
    }

    const std::vector<UpperEntry>& entries_;
    BinaryTree tree_;
    Collapse collapse_;
    const Config& config_;
    const std::string& name_;
    std::vector<std::uint32_t>& words_;
    std::vector<std::uint32_t>& placed_;
    std::uint32_t next_ = 0;
    UpperReport report_;
    Words scratch_;
};

}   // namespace

UpperReport write_upper(const std::vector<UpperEntry>& entries, std::uint32_t line, bool thorough,
                        const Config& config, const std::string& name, std::vector<std::uint32_t>& words,
                        std::vector<std::uint32_t>& placed) {
    std::vector<LatticeBox> boxes;
    boxes.reserve(entries.size());
    for (const UpperEntry& entry : entries) boxes.push_back(entry.map->box);
    BinaryTree tree = build_tree(boxes);
    if (thorough) optimise_tree(tree);
    placed.assign(entries.size(), 0);
    return UpperWriter(entries, std::move(tree), config, name, words, placed).run(line);
}

void write_entry(const UpperEntry& entry, std::uint32_t line, const Config& config,
                 std::vector<std::uint32_t>& words) {
    Words scratch;
    std::uint32_t* const at = &words[std::size_t(line) * words_per_line];
    std::fill_n(at, words_per_line, 0u);
    write_payload(Placement{entry.first, entry.root, entry.map->a, entry.map->b}, config, at, scratch);
    set_line_kind(at, LineKind::placement);
}

}   // namespace rayclock
