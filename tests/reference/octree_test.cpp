// Octrees by published rules: their counts, and rays against a search of all leaves.
#include <catch2/catch.hpp>

#include <cmath>

#include "model/reference/octree.hpp"
#include "model/scene/builtin.hpp"

using namespace rayclock;

namespace {

Scene two_spheres() {
    Scene scene;
    scene.spheres = {{{-3, -3, -3}, 1, 0}, {{3, 3, 3}, 1, 0}};
    return scene;
}

}   // namespace

TEST_CASE("an octree of two spheres in opposite corners is a node and eight leaves") {
    const RefOctree tree(two_spheres(), 5);
    CHECK(tree.objects() == 2);
    CHECK(tree.size().inner == 1);
    CHECK(tree.size().leaves == 8);
    CHECK(tree.size().empty == 6);
    CHECK(tree.size().references == 2);
}

TEST_CASE("a ray visits the octants on its way, as far as it goes") {
    const RefOctree tree(two_spheres(), 5);
    const auto walked = [&](const glm::dvec3& from, const glm::dvec3& direction, double reach) {
        OctreeWork work;
        tree.walk(from, direction, reach, work);
        return std::array<std::uint64_t, 3>{work.leaves, work.empty, work.tests};
    };
    const std::array<std::uint64_t, 3> two_and_two{4, 2, 2}, first{1, 0, 1}, nothing{0, 0, 0}, along{2, 1, 1};
    const glm::dvec3 askew = glm::dvec3(1, 1.1, 1.3);
    CHECK(walked({-3, -3, -3}, askew, HUGE_VAL) == two_and_two);
    CHECK(walked({-3, -3, -3}, askew, 0.5) == first);
    CHECK(walked({3, 3, 3}, -askew, HUGE_VAL) == two_and_two);
    CHECK(walked({-9, -3, -3}, {1, 0, 0}, HUGE_VAL) == along);
    CHECK(walked({-9, -3, -3}, {-1, 0, 0}, HUGE_VAL) == nothing);
    CHECK(walked({-9, -5, -3}, {1, 0, 0}, HUGE_VAL) == nothing);
    CHECK(walked({-9, -3, -3}, {1, 0, 0}, 4) == nothing);
}

// V. Havran, "Comparison of Octree Traversal Algorithms", 1999, at depth 5: inner nodes, leaves, empty ones,
// references. How far ours are off, and what of it is understood: docs/spd.md.
TEST_CASE("octrees of Haines' scenes are those that were published, but for a few cells in their faces") {
    struct Published {
        const char* scene;
        std::size_t objects;
        double inner, leaves, empty, references;
    };
    const auto p = GENERATE(Published{"balls:4", 7382, 117, 820, 570, 10946},
                            Published{"mount:6", 8196, 1019, 7134, 3060, 34351},
                            Published{"teapot:12", 9264, 1001, 7008, 3450, 34072});
    INFO(p.scene);
    const RefOctree tree(make_builtin(p.scene, Primitives::native), 5);
    CHECK(tree.objects() == p.objects);
    CHECK(double(tree.size().inner) == Approx(p.inner).epsilon(0.02));
    CHECK(double(tree.size().leaves) == Approx(p.leaves).epsilon(0.02));
    CHECK(double(tree.size().empty) == Approx(p.empty).epsilon(0.02));
    CHECK(double(tree.size().references) == Approx(p.references).epsilon(0.06));
}
