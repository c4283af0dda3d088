#pragma once
// A tree of boxes that follows its primitives from frame to frame. Refitting keeps the tree and makes its
// boxes anew, bottom-up, by the very rules by which they were built, so they hold what is below them. The
// tree gets worse by that; when its surface-area cost has grown by more than a ratio, it is built anew.
#include <string>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/layout/tree.hpp"

namespace rayclock {

/// Above so many times the cost that the tree had when it was built, it is built anew. What to take is
/// measured in docs/motion.md.
constexpr double usual_rebuild = 1.5;

class Refit {
public:
    /// For a machine with nodes of boxes, and without spatial splits.
    Refit(const Config& config, std::string name) : config_(config), name_(std::move(name)) {}
    static bool serves(const Config& config) { return config.is_bvh() && !config.has_splits(); }

    /// The tree over these primitives from now on. There is one, and number i has PrimData::prim = i. Returns
    /// true if the tree was built anew: it was the first time, or a refitted one would cost more than
    /// `rebuild` times what it cost when it was built. Throws UserError as compile_triangles() does.
    bool follow(std::vector<PrimData> prims, double rebuild);

    /// Writes the tree as lines from number `root` on; `words` are those of line `root` and of as many lines
    /// as are to be used, which are zeroed. `in_mesh`: nodes of a lower structure.
    void write(std::uint32_t root, bool in_mesh, std::uint32_t* words, std::uint32_t lines) const;

    /// Surface-area cost of the tree as it is, and over what it was when it was built.
    double cost() const;
    double ratio() const { return built_cost_ > 0 ? cost() / built_cost_ : 1; }
    const CompileReport& report() const { return report_; }   ///< of when it was built
    /// The most lines that a tree over so many primitives takes, however it is built.
    static std::uint64_t most_lines(std::uint64_t prims);

private:
    struct Leaf {
        std::uint32_t first = 0, count = 0;   ///< in content_
    };
    struct WideNode {
        std::uint32_t line = 0, base = 0;                                       ///< of the root in line 0
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
    std::vector<std::uint32_t> inner_;   // children that are nodes, in nodes_
    std::vector<Leaf> leaves_;
    std::vector<std::uint32_t> content_;   // of leaves, in prims_
    double built_cost_ = 0;
    CompileReport report_;
};

}   // namespace rayclock
