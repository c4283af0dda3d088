#pragma once
// The use of lines, shared by all writers of the scene's tree.
#include "model/compile/emit.hpp"
#include "model/compile/levels/upper.hpp"
#include "model/layout/words.hpp"

namespace rayclock {

class UpperLines {
public:
    /// Takes lines from `line` on; the first is the root's.
    UpperLines(std::uint32_t line, const Config& config, const std::string& name,
               std::vector<std::uint32_t>& words)
        : first_(line), next_(line), config_(config), name_(name), words_(words) {
        take(1);
    }
    const Config& config() const { return config_; }
    std::uint32_t taken() const { return next_ - first_; }

    /// Takes `count` more lines and returns the first. Throws UserError if they cannot be addressed.
    std::uint32_t take(std::size_t count) {
        const std::uint32_t first = next_;
        next_ += std::uint32_t(count);
        check_lines(next_, config_, name_);
        if (words_.size() < std::size_t(next_) * words_per_line)
            words_.resize(std::size_t(next_) * words_per_line, 0);
        return first;
    }
    template <class Node> void write(const Node& node, std::uint32_t line) {
        std::uint32_t* const at = &words_[std::size_t(line) * words_per_line];
        std::fill_n(at, words_per_line, 0u);
        write_payload(node, config_, at, scratch_);
    }

private:
    std::uint32_t first_, next_;
    const Config& config_;
    const std::string& name_;
    std::vector<std::uint32_t>& words_;
    Words scratch_;
};

/// The totals of a tree: its depth, and the sibling groups that a ray may have to keep.
struct UpperTotals {
    const std::vector<UpperEntry>& entries;
    std::vector<PlacedEntry>& placed;
    UpperReport report{};

    /// Records an entry in a line, in a node at this depth. Returns the number of groups kept below.
    int place(std::uint32_t entry, std::uint32_t line, int depth) {
        placed.push_back({entry, line});
        report.depth = std::max(report.depth, depth + 1 + entries[entry].depth);
        ++report.leaves;
        return entries[entry].stack_need;
    }
};

/// Writes the tree of a structure of planes over boxes.
UpperReport write_upper_cells(const std::vector<UpperEntry>& entries, const std::vector<LatticeBox>& boxes,
                              UpperLines& lines, std::uint32_t root, std::vector<PlacedEntry>& placed);

}   // namespace rayclock
