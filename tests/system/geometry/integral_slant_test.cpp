// Integral geometry for planes in any direction; integral_test.cpp explains the method. An exit's cell is
// convex: the slant's box, and one side of each plane on the path to the exit. So the number of lines that
// meet each cell follows from its surface. The surfaces are computed here without any code that decides about
// rays.
//
// A slant's box extends beyond the cell that contains it, so a walk does not visit all of them. The number of
// visits has a lower bound, the surfaces of each cell within the cells above it, and an upper bound, all
// surfaces.
#include <bit>

#include "model/compile/compile.hpp"
#include "model/trace/decoder.hpp"
#include "tests/support/geometry/convex.hpp"
#include "tests/support/geometry/lines.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr double ball_surface = 4 * std::numbers::pi * ball_radius * ball_radius;

struct Cells {
    double alone = 0, nested = 0;   ///< their surfaces, relative to the ball's
    int oblique = 0;                ///< planes that are not across an axis
};

struct Counts {
    int met = 0, visited = 0;
};

class Tree {
public:
    Tree(const std::vector<PrimData>& prims, const Config& config)
        : config_(config), image_(compile_triangles(prims, config, "the case")), decoder_(image_, config) {}

    /// Adds the cells of the exits of a slant and of everything below it. Includes leaves, since planes that
    /// are not across an axis lie low in the tree. `above` is the slant's own cell.
    void add(std::uint32_t line, const Convex& above, Cells& cells) const {
        const WideSlant& slant = decoder_.node<bsp::Engine>(line);
        for (const Vec3i& n : slant.normal) cells.oblique += (n[0] != 0) + (n[1] != 0) + (n[2] != 0) > 1;
        for (std::uint32_t child = 0; child < slant.exits.children; ++child) {
            Convex alone, nested = above;
            put(slant, slant.exit[child], alone);
            put(slant, slant.exit[child], nested);
            cells.alone += alone.surface() / ball_surface;
            cells.nested += nested.surface() / ball_surface;
            if (child < inner_of(slant)) add(slant.exits.base + child, nested, cells);
        }
    }
    /// Counts the exits whose cells a line meets, and those among them that an unlimited ray visits.
    void count(std::uint32_t line, const BoxRay& ray, const Vec3i& along, bool visited,
               Counts& counts) const {
        std::array<std::uint32_t, max_width> t_near;
        const WideSlant& slant = decoder_.node<bsp::Engine>(line);
        const std::uint32_t hits = slant_exits(ray, along, slant, config_, t_near.data());
        counts.met += std::popcount(hits);
        counts.visited += visited ? std::popcount(hits) : 0;
        for (std::uint32_t child = 0; child < inner_of(slant); ++child)
            count(slant.exits.base + child, ray, along, visited && (hits >> child & 1), counts);
    }

private:
    static std::uint32_t inner_of(const WideSlant& slant) {
        return std::uint32_t(std::popcount(slant.exits.inner_mask));
    }
    void put(const WideSlant& slant, int exit, Convex& cell) const {
        if (!slant.open) cell.within(slant.lo, slant.hi);
        std::size_t plane = 0;
        for (int half = config_.node_width / 2; half > 0; half /= 2) {
            const bool upper = exit & half;
            if (slant.normal[plane] != Vec3i{})
                upper ? cell.above(slant.normal[plane], slant.at[plane])
                      : cell.below(slant.normal[plane], slant.at[plane]);
            plane = 2 * plane + 1 + upper;
        }
    }

    Config config_;
    MemoryImage image_;
    Decoder decoder_;
};

void check_all(int lines) {
    Config config;
    config.structure = Structure::bsp;
    config.stack_depth = 64;
    for (const int width : {8, 2}) {
        config.node_width = width;
        INFO(width << " exits");
        const Tree tree(triangles(400, 20000, 14000), config);
        Cells cells;
        tree.add(0, {}, cells);
        CHECK(cells.oblique > 30);
        CHECK(cells.nested > 1);
        CHECK(cells.nested < cells.alone);
        Lines drawn(config);
        Mean met, visited;
        for (int i = 0; i < lines; ++i) {
            const Ray ray = drawn.next();
            Counts counts;
            tree.count(0, box_ray(ray), slant_direction(ray, config), true, counts);
            met.add(counts.met);
            visited.add(counts.visited);
        }
        met.check(cells.alone, cells.alone);
        visited.check(cells.nested, cells.alone);
    }
}

}   // namespace

TEST_CASE("the surface of a convex body is known", "[integral]") {
    Convex body;
    body.within({-3, 0, 10}, {1, 5, 12});
    CHECK(body.surface() == Approx(2 * (4 * 5 + 5 * 2 + 2 * 4)));
    body.below({1, 0, 0}, 7);   // beyond it,
    body.below({5, 0, 0}, 5);   // and equal to one of its planes, with a normal twice as long
    CHECK(body.surface() == Approx(2 * (4 * 5 + 5 * 2 + 2 * 4)));
    body.above({0, 0, 1}, 12);
    CHECK(body.surface() == Approx(2 * 4 * 5).epsilon(1e-4));   // flat
    body.above({0, 0, 1}, 13);
    CHECK(body.surface() < 1e-2);   // empty

    // The corner of a cube, cut off: three right-angled triangles, and one with three sides of 10 sqrt(2).
    Convex corner;
    corner.within({0, 0, 0}, {40, 40, 40});
    corner.below({1, 1, 1}, 10);
    CHECK(corner.surface() == Approx(150 + 50 * std::sqrt(3.0)));
}

TEST_CASE("lines meet as many cells of planes in any direction as integral geometry says",
          "[structures][integral]") {
    check_all(10000);
}

TEST_CASE("a million lines meet as many cells of planes in any direction as integral geometry says",
          "[structures][integral][slow]") {
    check_all(1000000);
}
