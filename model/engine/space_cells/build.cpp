// Builds trees of planes top-down, on all cores.
#include "model/engine/space_cells/build.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_invoke.h>

#include "model/engine/space_cells/treelets.hpp"

namespace rayclock::space_cells {

namespace {

constexpr std::size_t parallel_items = 4096;   // fewest items to build both sides in parallel

class Builder {
public:
    Builder(const Pieces& pieces, const Config& config, const ChooseCut& choose)
        : pieces_(pieces), choose_(choose), treelets_(config) {
        for (int width = config.node_width; width > 1; width /= 2) ++levels_;
    }

    /// Builds a cell with `level` planes above it and at most `depth` below.
    CellPtr cell(Items items, Region region, int level, int depth, double budget) const {
        pieces_.tell();
        auto cell = std::make_unique<Cell>();
        cell->bounds = bounds_of(items);
        cell->count = std::uint32_t(items.size());
        if (level % levels_ == 0 && !items.empty()) {
            // A treelet's line holds this box, so rays meet nothing outside it.
            region.box = cell->bounds;
            region.own = region.walls.size();
        }
        const Split split = best_split(items, region, depth);
        Items lower, upper;
        if (split.is_there()) pieces_.divide(items, region, split, lower, upper);
        const double given = double(lower.size() + upper.size());
        if (!split.is_there() || given > std::max(budget, double(items.size()))) return leaf_of(items);
        const bool both = items.size() >= parallel_items;
        Items().swap(items);
        cell->axis = std::uint32_t(split.axis);
        cell->lower_share = float(split.lower), cell->upper_share = float(split.upper);
        cell->normal = split.normal;
        cell->at = split.plane;
        if (split.axis != no_axis) cell->normal[split.axis] = 1;
        const double share = given > 0 ? budget / given : 0, for_lower = share * double(lower.size()),
                     for_upper = share * double(upper.size());
        const auto go_lower = [&] {
            cell->lower =
                this->cell(std::move(lower), region.part(split, false), level + 1, depth - 1, for_lower);
        };
        const auto go_upper = [&] {
            cell->upper =
                this->cell(std::move(upper), region.part(split, true), level + 1, depth - 1, for_upper);
        };
        if (both)
            tbb::parallel_invoke(go_lower, go_upper);
        else
            go_lower(), go_upper();
        cell->inside = treelets_.inside(*cell);
        return cell;
    }

private:
    Split best_split(const Items& items, const Region& region, int depth) const {
        Split best{{}, test_cost * double(items.size())};
        if (depth > 0 && !items.empty()) choose_(items, region, best);
        return best;
    }

    const Pieces& pieces_;
    const ChooseCut& choose_;
    Treelets treelets_;
    int levels_ = 0;   // of planes in a treelet
};

}   // namespace

CellPtr build(const Pieces& pieces, const Config& config, const ChooseCut& choose) {
    Items items = pieces.all();
    const double n = double(items.size());
    const int depth = std::min(34, 8 + int(1.3 * std::log2(std::max(1.0, n))));
    CellPtr root = Builder(pieces, config, choose)
                       .cell(std::move(items), {pieces.space()}, pieces.has_endless() ? 1 : 0, depth,
                             double(config.references) * n);
    Treelets(config).settle(*root, pieces.has_endless());
    return pieces.with_endless(std::move(root));
}

}   // namespace rayclock::space_cells
