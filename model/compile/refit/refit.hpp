#pragma once
// A tree of boxes that follows its primitives from frame to frame. Refitting keeps the tree and recomputes
// its boxes bottom-up, by the same rules by which they were built, so they hold everything below them. The
// tree gets worse. When its surface-area cost has grown beyond a ratio, it is rebuilt.
#include <string>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/layout/tree.hpp"

namespace rayclock {

/// The usual ratio of the cost to the cost when built, above which a tree is rebuilt. docs/machine/motion.md
/// has measurements.
constexpr double usual_rebuild = 1.5;

/// Requires a machine with nodes of boxes and without spatial splits.
class Refit {
public:
    Refit(const Config& config, std::string name) : config_(config), name_(std::move(name)) {}
    /// True if a tree of this configuration can be refitted.
    static bool serves(const Config& config) { return config.is_bvh() && !config.has_splits(); }

    /// Sets the tree's primitives. There must be at least one, and number i must have PrimData::prim = i.
    /// Returns true if the tree was built: the first time, or if the refitted tree would cost more than
    /// `rebuild` times the cost when built. Throws UserError as compile_triangles() does.
    bool follow(std::vector<PrimData> prims, double rebuild);

    /// Writes the tree as lines from number `root` on. `words` holds the `lines` lines from `root` on, and
    /// they are zeroed first. `in_mesh`: nodes of a lower structure.
    void write(std::uint32_t root, bool in_mesh, std::uint32_t* words, std::uint32_t lines) const;

    /// Return the surface-area cost of the current tree, and its ratio to the cost when built.
    double cost() const;
    double ratio() const { return built_cost_ > 0 ? cost() / built_cost_ : 1; }
    const CompileReport& report() const { return report_; }   ///< from the last build
    /// Returns the most lines of a tree over so many primitives, however it is built.
    static std::uint64_t max_lines(std::uint64_t prims);

private:
    struct Leaf {
        std::uint32_t first = 0, count = 0;   ///< in content_
    };
    struct WideNode {
        std::uint32_t line = 0, base = 0;                                       ///< with the root in line 0
        std::uint32_t first_inner = 0, inner = 0, first_leaf = 0, leaves = 0;   ///< in inner_ and leaves_
        LatticeBox box;
    };
    void build();
    void read(const MemoryImage& image);
    void fit();
    LatticeBox box_of(const Leaf& leaf) const;
    void write_node(const WideNode& node, std::uint32_t root, bool in_mesh, std::uint32_t* words) const;

    Config config_;
    std::string name_;
    std::vector<PrimData> prims_;
    std::vector<LatticeBox> boxes_;      // of prims_
    std::vector<WideNode> nodes_;        // parents before children
    std::vector<std::uint32_t> inner_;   // children that are nodes, as indices of nodes_
    std::vector<Leaf> leaves_;
    std::vector<std::uint32_t> content_;   // of leaves, as indices of prims_
    double built_cost_ = 0;
    CompileReport report_;
};

}   // namespace rayclock
