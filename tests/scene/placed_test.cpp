// Scenes that are made of instances.
#include <catch2/catch.hpp>

#include <glm/geometric.hpp>

#include "model/scene/placed.hpp"

using namespace rayclock;

namespace {

/// Not placed: the same triangles of the same materials with the same numbers, each corner as near as doubles
/// are.
void check_same(const PlacedScene& placed, const Scene& right, const Scene& flat) {
    CHECK(primitive_count(placed) == right.triangles.size());
    REQUIRE(flat.triangles.size() == right.triangles.size());
    REQUIRE(flat.vertices.size() == right.vertices.size());
    REQUIRE(flat.normals.size() == right.normals.size());
    double off = 0, turned = 0;
    for (std::size_t i = 0; i < flat.vertices.size(); ++i)
        off = std::max(off, glm::length(flat.vertices[i] - right.vertices[i]));
    for (std::size_t i = 0; i < flat.normals.size(); ++i)
        turned = std::max(turned, glm::length(flat.normals[i] - right.normals[i]));
    CHECK(off < 1e-14);
    CHECK(turned < 1e-12);
    for (std::size_t i = 0; i < flat.triangles.size(); ++i) {
        REQUIRE(flat.triangles[i].vertex == right.triangles[i].vertex);
        REQUIRE(flat.materials[flat.triangles[i].material].name ==
                right.materials[right.triangles[i].material].name);
    }
}

}   // namespace

TEST_CASE("The gearbox is one gear in many places, and the same as the gears", "[scene][placed]") {
    for (const int size : {1, 3}) {
        const std::string number = std::to_string(size);
        const PlacedScene placed = make_placed("gearbox:" + number);
        REQUIRE(placed.meshes.size() == 1);
        CHECK(placed.meshes[0].triangles.size() == 572);
        CHECK(placed.instances.size() == static_cast<std::size_t>(size * size * size));
        CHECK(placed.own.name == "gearbox:" + number);
        check_same(placed, make_builtin("gears:" + number), make_builtin("gearbox:" + number));
    }
}

TEST_CASE("The flake is one ball in many places, and the same as the balls", "[scene][placed]") {
    const PlacedScene placed = make_placed("flake:2");
    REQUIRE(placed.meshes.size() == 1);
    CHECK(placed.meshes[0].triangles.size() == 108);
    CHECK(placed.instances.size() == 1 + 9 + 81);
    check_same(placed, make_builtin("balls:2"), make_builtin("flake:2"));
}

TEST_CASE("The boughs are one cone and one ball in many places, and the same as the tree",
          "[scene][placed]") {
    const PlacedScene placed = make_placed("boughs:6");
    REQUIRE(placed.meshes.size() == 2);
    CHECK(placed.meshes[0].triangles.size() == 24);
    CHECK(placed.instances.size() == 2 * 127);
    check_same(placed, make_builtin("tree:6"), make_builtin("boughs:6"));
}

TEST_CASE("Other scenes have no instances, and are themselves when flattened", "[scene][placed]") {
    const PlacedScene placed = make_placed("gears:1");
    CHECK(placed.instances.empty());
    CHECK(flattened(placed).vertices == make_builtin("gears:1").vertices);
}
