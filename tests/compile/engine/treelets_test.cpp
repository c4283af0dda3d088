// Compares the planes of a kd-tree and its treelets with all possible planes and treelets.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>

#include "model/engine/kd/build.hpp"
#include "model/engine/space_cells/split.hpp"
#include "model/engine/space_cells/treelets.hpp"
#include "tests/compile/listed.hpp"
#include "tests/support/cases/draw.hpp"

using namespace rayclock;
using space_cells::Cell;
using space_cells::CellPtr;

namespace {

/// Draws boxes in a cell. A third of them are flat on an axis, many of these in the cell's sides, where cuts
/// leave primitives that lie in their plane.
space_cells::Items items(test::Draw& draw, std::uint32_t count, const LatticeBox& cell) {
    space_cells::Items items(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        items[i].prim = i;
        for (std::size_t k = 0; k < 3; ++k) {
            const int side = draw.between(0, 2),
                      a = side == 0   ? cell.lo[k]
                          : side == 1 ? cell.hi[k]
                                      : draw.between(cell.lo[k], cell.hi[k]),
                      b = draw.between(0, 2) == 0 ? a : draw.between(cell.lo[k], cell.hi[k]);
            items[i].box.lo[k] = std::min(a, b), items[i].box.hi[k] = std::max(a, b);
        }
    }
    return items;
}

/// Computes the cost of a plane by counting.
double cost_of_plane(const space_cells::Items& items, const LatticeBox& cell, std::size_t axis, int plane,
                     bool flat_above) {
    std::size_t below = 0, above = 0;
    for (const space_cells::Item& item : items) {
        const int lo = item.box.lo[axis], hi = item.box.hi[axis];
        const bool flat = lo == plane && hi == plane;
        below += lo < plane || (flat && !flat_above);
        above += hi > plane || (flat && flat_above);
    }
    LatticeBox lower = cell, upper = cell;
    lower.hi[axis] = upper.lo[axis] = plane;
    const auto weight = [](std::size_t n) {
        return n <= 16 ? double(n) : 16 * std::pow(double(n) / 16, 13.0 / 16);
    };
    const double tests = 20 * (lower.area() * weight(below) + upper.area() * weight(above)) / cell.area();
    return (8 + tests) * (below == 0 || above == 0 ? 0.9 : 1);
}

void check_split(test::Draw& draw, std::uint32_t count, int extent, int step) {
    const LatticeBox cell{{-extent, 3, -extent / 2}, {extent, 3 + extent, extent}};
    const space_cells::Items all = items(draw, count, cell);
    space_cells::Split best{{}, 1e9};
    space_cells::try_axes(all, cell, 2 * all.size(), best);
    REQUIRE(best.is_there());
    double least = 1e9;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::set<int> planes;
        for (int x = cell.lo[axis] + 1; x < cell.hi[axis]; x += step) planes.insert(x);
        for (const space_cells::Item& item : all)
            for (const int x :
                 {item.box.lo[axis], item.box.hi[axis], item.box.lo[axis] - 1, item.box.hi[axis] + 1})
                if (count < 100 && x > cell.lo[axis] && x < cell.hi[axis]) planes.insert(x);
        for (const int x : planes)
            for (const bool flat_above : {false, true})
                least = std::min(least, cost_of_plane(all, cell, axis, x, flat_above));
    }
    CHECK(best.cost <= least * (1 + 1e-12));
    CHECK(best.cost ==
          Approx(cost_of_plane(all, cell, best.axis, best.plane, best.flat_above)).epsilon(1e-12));
}

/// Returns a tree of random planes; every leaf has up to three primitives.
CellPtr random_tree(test::Draw& draw, const LatticeBox& box, int inner, std::uint32_t& next) {
    auto cell = std::make_unique<Cell>();
    cell->bounds = box;
    for (std::size_t k = 0; k < 3; ++k)
        cell->bounds.lo[k] = std::min(box.lo[k] + draw.between(0, 3), box.hi[k]);
    if (inner == 0) {
        for (int n = draw.between(0, 3); n > 0; --n) cell->prims.push_back(next++ % 4);
        std::sort(cell->prims.begin(), cell->prims.end());
        cell->count = std::uint32_t(cell->prims.size());
        return cell;
    }
    cell->axis = std::uint32_t(draw.between(0, 2));
    cell->at = draw.between(box.lo[cell->axis], box.hi[cell->axis]);
    LatticeBox below = box, above = box;
    below.hi[cell->axis] = above.lo[cell->axis] = cell->at;
    const int left = draw.between(0, inner - 1);
    cell->lower = random_tree(draw, below, left, next);
    cell->upper = random_tree(draw, above, inner - 1 - left, next);
    cell->count = cell->lower->count + cell->upper->count;
    return cell;
}

/// The cost of a choice of roles: role 0 is a leaf, 1 a new treelet, 2 a cut in the current treelet.
class Roles {
public:
    Roles(const Cell& root, int levels) : root_(root), levels_(levels) { number(root); }
    std::size_t size() const { return cells_.size(); }
    /// Returns the cost; infinite if no such treelet exists.
    double cost(const std::vector<int>& roles) {
        roles_ = &roles;
        return roles[0] == 1 ? parts(root_, root_.bounds, levels_ - 1) : HUGE_VAL;
    }

private:
    void number(const Cell& cell) {
        if (cell.is_leaf()) return;
        cells_.push_back(&cell);
        number(*cell.lower), number(*cell.upper);
    }
    double exit(const Cell& cell, const LatticeBox& box, int levels) {
        const double tests = 20 * box.area() * double(cell.count);
        if (cell.is_leaf()) return cell.count == 0 ? 0 : tests;
        const auto at = std::size_t(std::find(cells_.begin(), cells_.end(), &cell) - cells_.begin());
        switch ((*roles_)[at]) {
            case 0: return cell.count <= (1u << count_bits) - 2 ? tests : HUGE_VAL;
            case 1: return 17 * levels_ * box.area() + parts(cell, cell.bounds, levels_ - 1);
            default: return levels == 0 ? HUGE_VAL : parts(cell, box, levels - 1);
        }
    }
    double parts(const Cell& cell, const LatticeBox& box, int levels) {
        LatticeBox below = box, above = box;
        below.hi[cell.axis] = above.lo[cell.axis] =
            std::min(std::max(cell.at, box.lo[cell.axis]), box.hi[cell.axis]);
        return exit(*cell.lower, below, levels) + exit(*cell.upper, above, levels);
    }

    const Cell& root_;
    int levels_;
    std::vector<const Cell*> cells_;
    const std::vector<int>* roles_ = nullptr;
};

void compute_inside(Cell& cell, const space_cells::Treelets& treelets) {
    if (!cell.is_leaf()) compute_inside(*cell.lower, treelets), compute_inside(*cell.upper, treelets);
    cell.inside = treelets.inside(cell);
}

/// Collects the roles of a settled tree. They are 0 at its leaves and arbitrary below them.
void roles_of(const Cell& cell, const Cell& before, std::vector<int>& roles) {
    if (before.is_leaf()) return;
    const std::size_t at = roles.size();
    roles.push_back(cell.is_leaf() ? 0 : cell.begins ? 1 : 2);
    if (at == 0) roles[0] = 1;
    roles_of(cell.is_leaf() ? cell : *cell.lower, *before.lower, roles);
    roles_of(cell.is_leaf() ? cell : *cell.upper, *before.upper, roles);
}

std::set<std::uint32_t> prims_in(const Cell& cell) {
    std::set<std::uint32_t> all(cell.prims.begin(), cell.prims.end());
    if (cell.is_leaf()) return all;
    all.merge(prims_in(*cell.lower));
    all.merge(prims_in(*cell.upper));
    return all;
}
std::size_t twice_in_a_leaf(const Cell& cell) {
    if (!cell.is_leaf()) return twice_in_a_leaf(*cell.lower) + twice_in_a_leaf(*cell.upper);
    return cell.prims.size() - prims_in(cell).size();
}

constexpr int levels_of_eight = 3;

/// Returns the number of treelets for a leaf that is too large for an exit, with `levels` levels of planes
/// left.
std::size_t treelets_in(std::size_t prims, int levels) {
    if (prims <= (1u << count_bits) - 2) return 0;
    const int below = (levels > 0 ? levels : levels_of_eight) - 1;
    return (levels == 0) + treelets_in(prims / 2, below) + treelets_in(prims - prims / 2, below);
}
std::size_t treelets_in(const Cell& cell, int levels) {
    if (cell.is_leaf()) return treelets_in(cell.prims.size(), levels);
    const bool begins = cell.begins || levels == 0;
    const int below = (begins ? levels_of_eight : levels) - 1;
    return begins + treelets_in(*cell.lower, below) + treelets_in(*cell.upper, below);
}

}   // namespace

TEST_CASE("treelets begin only at chosen planes and at the ends of planes", "[treelets]") {
    for (const char* name : {"gears:1", "balls:2", "mount:4"}) {
        Config config;
        config.structure = Structure::kd;
        const std::vector<PrimData> prims = test::prims_of(name, config, Primitives::triangles);
        const CellPtr root = kd::build(prims, config);
        CHECK(compile_triangles(prims, config, name).report.nodes == treelets_in(*root, 0));
    }
}

TEST_CASE("no plane of a cell is cheaper than the one that is found", "[treelets]") {
    test::Draw draw{7};
    for (int i = 0; i < 120; ++i)
        check_split(draw, std::uint32_t(draw.between(1, i % 2 == 0 ? 40 : 4)), 30, 1);
    check_split(draw, 700, 60000, 997);
    check_split(draw, 5000, 60000, 9973);
}

TEST_CASE("no choice of treelets costs less than the one that is made", "[treelets]") {
    test::Draw draw{11};
    for (int i = 0; i < 60; ++i) {
        Config config;
        config.structure = Structure::kd;
        config.node_width = i % 3 == 0 ? 2 : i % 3 == 1 ? 4 : 8;
        const int levels = 1 + i % 3;
        const LatticeBox box{{0, 0, 0}, {draw.between(20, 99), draw.between(20, 99), draw.between(20, 99)}};
        std::uint32_t next = 0;
        const unsigned seed = unsigned(i) + 100;
        test::Draw first{seed}, again{seed};
        const CellPtr before = random_tree(first, box, 7, next);
        next = 0;
        const CellPtr tree = random_tree(again, box, 7, next);
        const space_cells::Treelets treelets(config);
        compute_inside(*tree, treelets);
        const double said = tree->inside;
        treelets.settle(*tree, false);
        CHECK(prims_in(*tree) == prims_in(*before));
        CHECK(twice_in_a_leaf(*tree) == 0);

        Roles all(*before, levels);
        std::vector<int> roles;
        roles_of(*tree, *before, roles);
        REQUIRE(roles.size() == all.size());
        CHECK(all.cost(roles) == Approx(said).epsilon(1e-12));
        double least = HUGE_VAL;
        std::vector<int> other(all.size(), 0);
        for (bool more = true; more;) {
            other[0] = 1;
            least = std::min(least, all.cost(other));
            more = false;
            for (std::size_t k = 1; k < other.size() && !more; ++k) {
                other[k] = (other[k] + 1) % 3;
                more = other[k] != 0;
            }
        }
        CHECK(said == Approx(least).epsilon(1e-12));
    }
}
