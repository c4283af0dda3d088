// Builds the binary tree of boxes with spatial splits.
#include "model/engine/bvh/splits.hpp"

#include <array>
#include <memory>

#include <tbb/parallel_invoke.h>

#include "model/engine/bvh/divide.hpp"
#include "model/engine/space_cells/clip.hpp"

namespace rayclock::bvh {

namespace {

constexpr double least_overlap = 1e-5;   // as a share of the root's surface
constexpr std::size_t slabs = 16;        // parts of a cell on an axis; the candidate planes lie between them
using Items = std::vector<BoxItem>;

/// A subtree under construction. Its number of leaves is not known in advance.
struct Branch {
    LatticeBox box;
    std::uint32_t index = 0;   ///< of a leaf
    std::unique_ptr<Branch> left, right;
};
using BranchPtr = std::unique_ptr<Branch>;

/// The items of one side, and the box around them. `count` may differ from the list's length.
struct Side {
    Items items;
    LatticeBox box;
    double count = 0;
    void add(const BoxItem& item) {
        items.push_back(item);
        box.add(item.box);
        ++count;
    }
};

double cost_of(const LatticeBox& lower, double below, const LatticeBox& upper, double above) {
    return lower.area() * below + upper.area() * above;
}

bool is_empty(const LatticeBox& box) { return box.lo[0] > box.hi[0]; }

/// Returns the surface of the common part of two boxes.
double overlap(const LatticeBox& a, const LatticeBox& b) {
    LatticeBox common;
    for (std::size_t k = 0; k < 3; ++k) {
        common.lo[k] = std::max(a.lo[k], b.lo[k]);
        common.hi[k] = std::min(a.hi[k], b.hi[k]);
        if (common.lo[k] > common.hi[k]) return 0;
    }
    return common.area();
}

struct SplitPlane {
    double cost = 0;
    std::size_t axis = 3;
    std::int32_t at = 0;
    bool is_there() const { return axis < 3; }
};

class SplitBuilder {
public:
    SplitBuilder(const std::vector<LatticeBox>& boxes, const std::vector<PrimData>& prims,
                 const Config& config)
        : endless_(prims.size()) {
        LatticeBox all;
        clippers_.reserve(prims.size());
        for (std::size_t i = 0; i < prims.size(); ++i) {
            clippers_.emplace_back(prims[i], config.coord_bits, config.is_sheared() ? 1 : 0);
            endless_[i] = prims[i].kind == PrimKind::plane;
            if (!endless_[i]) all.add(boxes[i]);
        }
        if (!is_empty(all)) least_ = least_overlap * all.area();
    }

    BranchPtr build(Items items, int depth, double budget) const {
        auto branch = std::make_unique<Branch>();
        LatticeBox centres;
        for (const BoxItem& item : items) {
            branch->box.add(item.box);
            centres.add(Vec3i{item.box.centre(0), item.box.centre(1), item.box.centre(2)});
        }
        if (items.size() == 1) {
            branch->index = items[0].index;
            return branch;
        }
        Side lower, upper;
        const bool both = items.size() >= parallel_from;
        halves(items, branch->box, centres, depth, budget, lower, upper);
        Items().swap(items);
        const double n = double(lower.items.size()), share = budget / (n + double(upper.items.size()));
        const auto left = [&] { branch->left = build(std::move(lower.items), depth + 1, share * n); };
        const auto right = [&] {
            branch->right = build(std::move(upper.items), depth + 1, budget - share * n);
        };
        if (both)
            tbb::parallel_invoke(left, right);
        else
            left(), right();
        return branch;
    }

private:
    /// Divides the items into two sides, by a plane if that is cheaper.
    void halves(Items& items, const LatticeBox& box, const LatticeBox& centres, int depth, double budget,
                Side& lower, Side& upper) const {
        const std::size_t n = divide(items, centres, depth);
        for (std::size_t i = 0; i < items.size(); ++i) (i < n ? lower : upper).add(items[i]);
        if (depth > max_sah_depth || overlap(lower.box, upper.box) <= least_) return;
        for (const BoxItem& item : items)
            if (endless_[item.index]) return;
        SplitPlane plane{cost_of(lower.box, lower.count, upper.box, upper.count)};
        for (std::size_t axis = 0; axis < 3; ++axis) try_planes(items, box, axis, plane);
        if (!plane.is_there()) return;
        Side below, above;
        cut(items, plane, below, above);
        const std::size_t a = below.items.size(), b = above.items.size();
        if (a == 0 || b == 0 || a == items.size() || b == items.size() || double(a + b) > budget) return;
        lower = std::move(below), upper = std::move(above);
    }

    /// Replaces `best` by the cheapest plane on an axis, if that is cheaper.
    void try_planes(const Items& items, const LatticeBox& box, std::size_t axis, SplitPlane& best) const {
        const std::int64_t lo = box.lo[axis], extent = box.hi[axis] - lo;
        if (extent < std::int64_t(slabs)) return;
        std::array<std::int32_t, slabs + 1> plane;   // slab i lies between planes i and i + 1
        for (std::size_t i = 0; i <= slabs; ++i)
            plane[i] = std::int32_t(lo + extent * std::int64_t(i) / std::int64_t(slabs));
        const auto slab_of = [&](std::int32_t x) {   // the last slab that begins at x or before
            auto slab = std::size_t((x - lo) * std::int64_t(slabs) / extent);
            while (slab + 1 < slabs && plane[slab + 1] <= x) ++slab;
            return std::min(slab, slabs - 1);
        };
        std::array<LatticeBox, slabs> held;
        std::array<std::size_t, slabs> begins{}, ends{};
        for (const BoxItem& item : items) {
            const std::size_t first = slab_of(item.box.lo[axis]),
                              last = slab_of(std::max(item.box.lo[axis], item.box.hi[axis] - 1));
            ++begins[first], ++ends[last];
            if (first == last) held[first].add(item.box);
            for (std::size_t i = first; first < last && i <= last; ++i)
                if (const auto part = clipped(item, axis, plane[i], plane[i + 1])) held[i].add(*part);
        }
        consider(held, begins, ends, items.size(), axis, plane, best);
    }

    static void consider(const std::array<LatticeBox, slabs>& held,
                         const std::array<std::size_t, slabs>& begins,
                         const std::array<std::size_t, slabs>& ends, std::size_t all, std::size_t axis,
                         const std::array<std::int32_t, slabs + 1>& plane, SplitPlane& best) {
        std::array<LatticeBox, slabs> upper;   // of slab i and those above
        LatticeBox box;
        for (std::size_t i = slabs; i-- > 0;) box.add(held[i]), upper[i] = box;
        LatticeBox lower;
        std::size_t below = 0, ended = 0;
        for (std::size_t i = 1; i < slabs; ++i) {
            lower.add(held[i - 1]);
            below += begins[i - 1], ended += ends[i - 1];
            const std::size_t above = all - ended;
            if (below == all || above == all || is_empty(lower) || is_empty(upper[i])) continue;
            const double cost = cost_of(lower, double(below), upper[i], double(above));
            if (cost < best.cost) best = {cost, axis, plane[i]};
        }
    }

    std::optional<LatticeBox> clipped(const BoxItem& item, std::size_t axis, std::int32_t lo,
                                      std::int32_t hi) const {
        LatticeBox part = item.box;
        part.lo[axis] = std::max(part.lo[axis], lo);
        part.hi[axis] = std::min(part.hi[axis], hi);
        return clippers_[item.index](part);
    }

    /// Distributes the items. Items that the plane does not cut go to their side; items in the plane go below
    /// it. Each other item takes the cheapest of three ways: in both sides, or whole in one of them.
    void cut(const Items& items, const SplitPlane& plane, Side& lower, Side& upper) const {
        struct Straddler {
            BoxItem whole;
            LatticeBox below, above;
        };
        std::vector<Straddler> straddlers;
        for (const BoxItem& item : items) {
            const std::int32_t lo = item.box.lo[plane.axis], hi = item.box.hi[plane.axis];
            if (hi <= plane.at || lo >= plane.at) {
                (hi <= plane.at ? lower : upper).add(item);
                continue;
            }
            const auto below = clipped(item, plane.axis, lo, plane.at),
                       above = clipped(item, plane.axis, plane.at, hi);
            if (below && above)
                straddlers.push_back({item, *below, *above});
            else   // everything that can be hit is on one side
                (below ? lower : upper).add(item);
        }
        for (const Straddler& s : straddlers) {
            lower.box.add(s.below), upper.box.add(s.above);
            ++lower.count, ++upper.count;
        }
        for (const Straddler& s : straddlers) {
            const LatticeBox with_lower = merged(lower.box, s.whole.box),
                             with_upper = merged(upper.box, s.whole.box);
            const double in_both = cost_of(lower.box, lower.count, upper.box, upper.count),
                         in_lower = cost_of(with_lower, lower.count, upper.box, upper.count - 1),
                         in_upper = cost_of(lower.box, lower.count - 1, with_upper, upper.count);
            if (in_lower <= in_both && in_lower <= in_upper) {
                lower.items.push_back(s.whole), lower.box = with_lower, --upper.count;
            } else if (in_upper <= in_both) {
                upper.items.push_back(s.whole), upper.box = with_upper, --lower.count;
            } else {
                lower.items.push_back({s.below, s.whole.index});
                upper.items.push_back({s.above, s.whole.index});
            }
        }
    }

    std::vector<space_cells::Clipper> clippers_;
    std::vector<bool> endless_;
    double least_ = 0;   // overlap
};

/// Appends a subtree, parents before children. Returns its root's place.
std::uint32_t append(const Branch& branch, std::vector<BinaryNode>& nodes) {
    const auto at = std::uint32_t(nodes.size());
    nodes.push_back({branch.box, branch.index, no_node});
    if (!branch.left) return at;
    const std::uint32_t left = append(*branch.left, nodes), right = append(*branch.right, nodes);
    nodes[at].left = left, nodes[at].right = right;
    return at;
}

}   // namespace

BinaryTree build_split_tree(const std::vector<LatticeBox>& boxes, const std::vector<PrimData>& prims,
                            const Config& config) {
    Items items(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) items[i] = {boxes[i], std::uint32_t(i)};
    const double budget = max_split_references * double(items.size());
    const BranchPtr root = SplitBuilder(boxes, prims, config).build(std::move(items), 0, budget);
    BinaryTree tree;
    append(*root, tree.nodes);
    return tree;
}

}   // namespace rayclock::bvh
