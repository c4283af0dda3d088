// Octrees by published rules: their counts, and rays compared with a search of all leaves.
#include <catch2/catch.hpp>

#include <cmath>

#include "sim/judge/reference/octree.hpp"
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

TEST_CASE("a shadow ray ends at the first test of what is in its way") {
    Scene scene = two_spheres();
    scene.spheres.push_back({{2.5, 3, 3}, 1, 0});
    const RefOctree tree(scene, 1);
    const auto tests = [&](const std::vector<std::uint32_t>& blockers) {
        OctreeWork work;
        tree.walk({-3, -3, -3}, {1, 1.1, 1.3}, HUGE_VAL, work, blockers);
        return std::pair{work.leaves, work.tests};
    };
    using Two = std::pair<std::uint64_t, std::uint64_t>;
    CHECK(tests({}) == Two{4, 3});
    CHECK(tests({0}) == Two{1, 1});
    CHECK(tests({2}) == Two{4, 3});
    CHECK(tests({2, 1}) == Two{4, 2});
    CHECK(tests({1, 2}) == Two{4, 2});
}

// V. Havran, "Comparison of Octree Traversal Algorithms", 1999: inner nodes, leaves, empty leaves,
// references. docs/measured/ray-counts.md explains the deviations.
TEST_CASE("octrees of Haines' scenes are those that were published") {
    struct Published {
        const char* scene;
        std::size_t objects;
        int depth;
        OctreeSize size;
        double off = 0;   ///< deviation of references; the deviations of the others are not larger
    };
    const auto p = GENERATE(Published{"balls:4", 7382, 4, {57, 400, 300, 9171}},
                            Published{"balls:4", 7382, 5, {117, 820, 570, 10946}},
                            Published{"balls:4", 7382, 6, {304, 2129, 1038, 15611}},
                            Published{"balls:4", 7382, 7, {1108, 7757, 2905, 27288}},
                            Published{"gears:4", 9345, 4, {265, 1856, 652, 39440}},
                            Published{"gears:4", 9345, 5, {1405, 9836, 4088, 85832}},
                            Published{"gears:4", 9345, 6, {5837, 40860, 10334, 235526}},
                            Published{"gears:4", 9345, 7, {28447, 199130, 28228, 879434}},
                            Published{"mount:6", 8196, 4, {232, 1625, 777, 18107}, 0.0013},
                            Published{"mount:6", 8196, 7, {22630, 158411, 45049, 324918}, 0.0005},
                            Published{"teapot:12", 9264, 4, {227, 1590, 777, 18845}, 0.0095},
                            Published{"teapot:12", 9264, 7, {18066, 126463, 38316, 295865}, 0.003});
    INFO(p.scene << " " << p.depth);
    const RefOctree tree(make_builtin(p.scene, Primitives::native), p.depth);
    CHECK(tree.objects() == p.objects);
    const auto is = [&](std::uint64_t mine, std::uint64_t his) {
        return std::abs(double(mine) - double(his)) <= p.off * double(his);
    };
    CHECK(is(tree.size().inner, p.size.inner));
    CHECK(is(tree.size().leaves, p.size.leaves));
    CHECK(is(tree.size().empty, p.size.empty));
    CHECK(is(tree.size().references, p.size.references));
}

TEST_CASE("what was one polygon is one object of an octree") {
    Scene scene;   // an L of four triangles, a neighbour in its plane, and one that faces down
    scene.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0},
                      {0, 2, 0}, {5, 0, 0}, {6, 0, 0}, {6, 1, 0}};
    scene.materials.resize(2);
    scene.triangles = {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 4}}, {{0, 4, 5}}, {{6, 7, 8}}, {{6, 8, 7}}};
    CHECK(RefOctree(scene, 1).objects() == 3);
    scene.triangles[1].material = 1;
    CHECK(RefOctree(scene, 1).objects() == 5);
}
