// Builds bounding interval hierarchies from trees of boxes.
#include "model/engine/bih/build.hpp"

#include "model/engine/bvh/build.hpp"
#include "model/engine/space_cells/treelets.hpp"
#include "model/layout/tree.hpp"

namespace rayclock::bih {

namespace {

class Builder {
public:
    Builder(const BinaryTree& tree, const space_cells::Items& items, const Config& config)
        : tree_(tree), items_(items), treelets_(config) {}

    space_cells::CellPtr cell(std::uint32_t at) const {
        const BinaryNode& node = tree_.nodes[at];
        if (node.is_leaf()) return space_cells::leaf_of({items_[node.left]});
        auto cell = std::make_unique<space_cells::Cell>();
        space_cells::CellPtr left = this->cell(node.left), right = this->cell(node.right);
        cell->bounds = node.box;
        cell->count = left->count + right->count;
        cell->axis = widest_gap(left->bounds, right->bounds);
        if (left->bounds.centre(cell->axis) > right->bounds.centre(cell->axis)) std::swap(left, right);
        // The middle between the two planes. Only the cost of lines uses it.
        cell->at = (left->bounds.hi[cell->axis] + right->bounds.lo[cell->axis]) / 2;
        cell->lower = std::move(left), cell->upper = std::move(right);
        cell->inside = treelets_.inside(*cell);
        return cell;
    }

private:
    /// Returns the axis on which two boxes are farthest apart, or overlap least.
    static std::uint32_t widest_gap(const LatticeBox& a, const LatticeBox& b) {
        std::uint32_t best = 0;
        std::int32_t most = 0;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::int32_t gap = std::max(a.lo[k] - b.hi[k], b.lo[k] - a.hi[k]);
            if (k == 0 || gap > most) best = k, most = gap;
        }
        return best;
    }

    const BinaryTree& tree_;
    const space_cells::Items& items_;
    space_cells::Treelets treelets_;
};

}   // namespace

space_cells::CellPtr build(const space_cells::Pieces& pieces, const Config& config) {
    const space_cells::Items items = pieces.all();
    if (items.empty()) return pieces.with_endless(space_cells::leaf_of(items));
    std::vector<LatticeBox> boxes;
    boxes.reserve(items.size());
    for (const space_cells::Item& item : items) boxes.push_back(item.box);
    BinaryTree tree = bvh::build_tree(boxes);
    bvh::optimise_tree(tree);
    space_cells::CellPtr root = Builder(tree, items, config).cell(tree.root);
    space_cells::Treelets(config).settle(*root, pieces.has_endless());
    return pieces.with_endless(std::move(root));
}

}   // namespace rayclock::bih
