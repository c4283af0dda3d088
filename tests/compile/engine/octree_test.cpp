// The octree: halves in the middle, on three axes at once, and both rules for primitives that a plane cuts.
#include <catch2/catch.hpp>

#include <set>

#include "model/engine/octree/build.hpp"
#include "tests/support/cases/draw.hpp"

using namespace rayclock;
using space_cells::Cell;

namespace {

Config octree_of(int leaf_size, Straddlers straddlers) {
    Config config;
    config.structure = Structure::octree;
    config.leaf_size = leaf_size;
    config.straddlers = straddlers;
    return config;
}

/// Returns small triangles anywhere, and one from end to end.
std::vector<PrimData> triangles(std::uint32_t count, int extent) {
    test::Draw draw{count};
    std::vector<PrimData> prims;
    const auto at = [&](int middle) { return middle + draw.between(-40, 40); };
    for (std::uint32_t i = 0; i < count; ++i) {
        const int x = draw.between(-extent, extent), y = draw.between(-extent, extent),
                  z = draw.between(-extent, extent);
        prims.push_back({{at(x), at(y), at(z)}, {at(x), at(y), at(z)}, {at(x), at(y), at(z)}, i});
    }
    prims.push_back({{-extent, -extent, -extent}, {extent, extent, extent}, {extent, -extent, 0}, count});
    return prims;
}

/// Counts from a tree's cells.
class Census {
public:
    explicit Census(std::size_t leaf_size) : leaf_size_(leaf_size) {}
    std::set<std::uint32_t> seen;
    std::size_t references = 0, leaves = 0;
    std::size_t crowded = 0;   ///< leaves that exceed their size and could have been cut
    std::size_t beside = 0;    ///< leaves for primitives that stay in an inner node

    void count(const Cell& cell, const LatticeBox& box, std::uint32_t axis, int depth) {
        if (cell.is_leaf()) {
            leaf(cell);
            crowded += axis == 0 && cell.prims.size() > leaf_size_ && depth < octree::max_depth;
            return;
        }
        if (cell.axis == no_axis) {   // its own primitives, and its octants
            REQUIRE(axis == 0);
            REQUIRE(cell.lower->is_leaf());
            leaf(*cell.lower);
            ++beside;
            count(*cell.upper, box, 0, depth);
            return;
        }
        REQUIRE(cell.axis == axis);
        REQUIRE(cell.at == (box.lo[axis] + box.hi[axis]) >> 1);
        LatticeBox below = box, above = box;
        below.hi[axis] = above.lo[axis] = cell.at;
        count(*cell.lower, below, (axis + 1) % 3, depth + (axis == 2));
        count(*cell.upper, above, (axis + 1) % 3, depth + (axis == 2));
    }

private:
    void leaf(const Cell& cell) {
        references += cell.prims.size();
        ++leaves;
        seen.insert(cell.prims.begin(), cell.prims.end());
    }
    std::size_t leaf_size_;
};

Census census_of(const std::vector<PrimData>& prims, const Config& config) {
    const space_cells::CellPtr root = octree::build(prims, config);
    Census census(std::size_t(config.leaf_size));
    census.count(*root, root->bounds, 0, 0);
    return census;
}

}   // namespace

TEST_CASE("an octree halves each cell on three axes until its primitives fit one leaf") {
    const int leaf_size = GENERATE(1, 4);
    const auto prims = triangles(3000, 60000);
    const Census census = census_of(prims, octree_of(leaf_size, Straddlers::leaves));
    CHECK(census.seen.size() == prims.size());
    CHECK(census.references > prims.size());
    CHECK(census.references <= std::size_t(Config{}.references) * prims.size());
    CHECK(census.crowded < census.leaves / 100);   // limited by the bound on references
    CHECK(census.beside == 0);
}

TEST_CASE("with straddlers in inner nodes, each straddling primitive is in its inner node and nowhere else") {
    const auto prims = triangles(3000, 60000);
    const Census census = census_of(prims, octree_of(1, Straddlers::inner));
    CHECK(census.seen.size() == prims.size());
    CHECK(census.references == prims.size());
    CHECK(census.crowded == 0);
    CHECK(census.beside > 0);
}

TEST_CASE("an octree of a flat scene has no planes across it") {
    std::vector<PrimData> prims;
    for (int i = 0; i < 100; ++i)
        prims.push_back({{40 * i, 0, 7}, {40 * i + 30, 0, 7}, {40 * i, 30, 7}, std::uint32_t(i)});
    const space_cells::CellPtr root = octree::build(prims, octree_of(1, Straddlers::leaves));
    REQUIRE(!root->is_leaf());
    const Cell& quarter = *root->lower->lower;
    CHECK(quarter.axis == no_axis);
    CHECK(quarter.upper->prims.empty());
}
