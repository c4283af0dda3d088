// Builds octrees top-down, on all cores.
#include "model/engine/octree/build.hpp"

#include <array>

#include <tbb/parallel_for.h>

namespace rayclock::octree {

namespace {

using space_cells::Cell;
using space_cells::CellPtr;
using space_cells::Cut;
using space_cells::Items;

constexpr std::size_t parallel = 4096;   // items from which octants are built at once

/// Part of a node's cell: one of its octants, or several that are not yet cut from each other.
struct Part {
    Items items;
    LatticeBox box;
};
using Octants = std::array<Part, 8>;

/// Returns the plane that halves a cell; none where the cell is too thin.
Cut middle(const LatticeBox& box, std::size_t axis) {
    if (box.hi[axis] - box.lo[axis] < 2) return {};
    return {axis, (box.lo[axis] + box.hi[axis]) >> 1};
}

class Builder {
public:
    Builder(const space_cells::Pieces& pieces, const Config& config)
        : pieces_(pieces),
          leaf_size_(std::size_t(config.leaf_size)),
          inner_(config.straddlers == Straddlers::inner) {}

    CellPtr node(Part part, int depth, double budget) const {
        pieces_.tell();
        const bool can_be_cut = !(middle(part.box, 0).axis == no_axis &&
                                  middle(part.box, 1).axis == no_axis && middle(part.box, 2).axis == no_axis);
        if (part.items.size() <= leaf_size_ || depth == 0 || !can_be_cut) return leaf_of(part.items);
        const std::size_t given_to = part.items.size();
        const Items own = inner_ ? straddlers(part) : Items{};
        const LatticeBox box = part.box;
        Octants octants;
        halve(part, 0, octants.data());
        std::size_t given = own.size();
        for (const Part& octant : octants) given += octant.items.size();
        if (double(given) > std::max(budget, double(given_to))) return leaf_of(part.items);
        Items().swap(part.items);
        std::array<CellPtr, 8> cells;
        const auto go_down = [&](std::size_t i) {
            const double share = budget / double(given) * double(octants[i].items.size());
            cells[i] = node(std::move(octants[i]), depth - 1, share);
        };
        if (given_to >= parallel)
            tbb::parallel_for(std::size_t(0), cells.size(), go_down);
        else
            for (std::size_t i = 0; i < cells.size(); ++i) go_down(i);
        CellPtr tree = joined(cells.data(), box, 0);
        return own.empty() ? std::move(tree) : parent_of(leaf_of(own), std::move(tree));
    }

private:
    /// Removes the items on both sides of one of the middle planes from a part, and returns them.
    static Items straddlers(Part& part) {
        Items own, rest;
        for (const space_cells::Item& item : part.items) {
            bool straddles = false;
            for (std::size_t k = 0; k < 3; ++k) {
                const Cut cut = middle(part.box, k);
                straddles = straddles ||
                            (cut.axis != no_axis && item.box.lo[k] < cut.plane && item.box.hi[k] > cut.plane);
            }
            (straddles ? own : rest).push_back(item);
        }
        part.items = std::move(rest);
        return own;
    }

    /// Fills the octants of a part that is not yet cut on `axis` and the axes after it, lower sides first. On
    /// an axis without a plane, everything goes to the lower side.
    void halve(const Part& part, std::size_t axis, Part* octants) const {
        if (axis == 3) {
            *octants = part;
            return;
        }
        const Cut cut = middle(part.box, axis);
        Part lower{{}, part.box}, upper{{}, part.box};
        if (cut.axis == no_axis) {
            lower.items = part.items;
        } else {
            lower.box.hi[axis] = upper.box.lo[axis] = cut.plane;
            pieces_.divide(part.items, {part.box}, cut, lower.items, upper.items);
        }
        halve(lower, axis + 1, octants);
        halve(upper, axis + 1, octants + (std::size_t(4) >> axis));
    }

    /// Joins the cells of a part's octants under the planes that cut it.
    static CellPtr joined(CellPtr* octants, LatticeBox box, std::size_t axis) {
        if (axis == 3) return std::move(*octants);
        const std::size_t half = std::size_t(4) >> axis;
        bool is_empty = true;
        for (std::size_t i = 0; i < 2 * half; ++i)
            is_empty = is_empty && octants[i]->is_leaf() && octants[i]->prims.empty();
        if (is_empty) return std::make_unique<Cell>();
        const Cut cut = middle(box, axis);
        LatticeBox below = box, above = box;
        if (cut.axis != no_axis) below.hi[axis] = above.lo[axis] = cut.plane;
        CellPtr cell = parent_of(joined(octants, below, axis + 1), joined(octants + half, above, axis + 1));
        cell->axis = std::uint32_t(cut.axis);
        cell->at = cut.plane;
        return cell;
    }
    static CellPtr parent_of(CellPtr lower, CellPtr upper) {
        auto cell = std::make_unique<Cell>();
        cell->bounds = merged(lower->bounds, upper->bounds);
        cell->lower = std::move(lower);
        cell->upper = std::move(upper);
        return cell;
    }

    const space_cells::Pieces& pieces_;
    std::size_t leaf_size_;
    bool inner_;
};

}   // namespace

CellPtr build(const std::vector<PrimData>& prims, const Config& config) {
    return build(space_cells::Pieces(prims, config), config);
}

CellPtr build(const space_cells::Pieces& pieces, const Config& config) {
    Items items = pieces.all();
    const double most = double(config.references) * double(items.size());
    const LatticeBox box = space_cells::bounds_of(items);
    return pieces.with_endless(Builder(pieces, config).node({std::move(items), box}, max_depth, most));
}

}   // namespace rayclock::octree
