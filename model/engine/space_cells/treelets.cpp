// The dynamic program of treelets.hpp.
#include "model/engine/space_cells/treelets.hpp"

#include <algorithm>

#include <tbb/parallel_invoke.h>

namespace rayclock::space_cells {

namespace {

constexpr double level = 17, test = 20;   // level: of a visit, per level of planes in a treelet
constexpr std::size_t leaf_most = (1u << count_bits) - 2;   // primitives of an exit
constexpr std::size_t parallel_settle = 4096;               // fewest items to settle both sides in parallel

void gather(const Cell& cell, std::vector<std::uint32_t>& prims) {
    prims.insert(prims.end(), cell.prims.begin(), cell.prims.end());
    if (cell.is_leaf()) return;
    gather(*cell.lower, prims);
    gather(*cell.upper, prims);
}

/// Turns a cell into a leaf: its primitives in the order of the scene, each once.
void make_leaf(Cell& cell) {
    gather(cell, cell.prims);
    std::sort(cell.prims.begin(), cell.prims.end());
    cell.prims.erase(std::unique(cell.prims.begin(), cell.prims.end()), cell.prims.end());
    cell.lower.reset();
    cell.upper.reset();
}

}   // namespace

Treelets::Treelets(const Config& config) {
    for (int width = config.node_width; width > 1; width /= 2) ++levels_;
}

Treelets::Space Treelets::part(const Space& space, const Cell& cell, bool upper) {
    Space part = space;
    if (cell.axis == no_axis) {
        part.share *= double(upper ? cell.upper_share : cell.lower_share);
        return part;
    }
    const std::size_t k = cell.axis;
    (upper ? part.box.lo : part.box.hi)[k] = std::clamp(cell.at, space.box.lo[k], space.box.hi[k]);
    return part;
}

double Treelets::inside(const Cell& cell) const {
    return cell.is_leaf() ? 0 : parts(cell, {cell.bounds}, levels_ - 1);
}

double Treelets::parts(const Cell& cell, const Space& space, int levels) const {
    return best(*cell.lower, part(space, cell, false), levels).cost +
           best(*cell.upper, part(space, cell, true), levels).cost;
}

Treelets::Choice Treelets::best(const Cell& cell, const Space& space, int levels) const {
    if (cell.count == 0) return {};
    const double area = space.area(), tests = area * test * double(cell.count);
    if (cell.is_leaf()) return {tests};
    Choice best{area * level * levels_ + cell.inside, Role::root};
    if (cell.count <= leaf_most && tests <= best.cost) best = {tests};
    if (levels == 0) return best;
    const double cost = parts(cell, space, levels - 1);
    return cost <= best.cost ? Choice{cost, Role::cut} : best;
}

void Treelets::settle(Cell& root, bool under) const {
    if (root.is_leaf()) return;
    if (under) return settle(root, {root.bounds}, levels_ - 1);
    settle_parts(root, {root.bounds}, levels_ - 1);
}

void Treelets::settle(Cell& cell, const Space& space, int levels) const {
    if (cell.is_leaf()) return;
    const Role role = best(cell, space, levels).role;
    if (role == Role::leaf) return make_leaf(cell);
    cell.begins = role == Role::root;
    if (cell.begins)
        settle_parts(cell, {cell.bounds}, levels_ - 1);
    else
        settle_parts(cell, space, levels - 1);
}

void Treelets::settle_parts(Cell& cell, const Space& space, int levels) const {
    const auto lower = [&] { settle(*cell.lower, part(space, cell, false), levels); };
    const auto upper = [&] { settle(*cell.upper, part(space, cell, true), levels); };
    if (cell.count >= parallel_settle)
        tbb::parallel_invoke(lower, upper);
    else
        lower(), upper();
}

}   // namespace rayclock::space_cells
