// Scenes that are made of instances.
#include <catch2/catch.hpp>

#include <glm/geometric.hpp>

#include "model/scene/placed.hpp"

using namespace rayclock;

TEST_CASE("The gearbox is one gear in many places, and the same as the gears", "[scene][placed]") {
    for (const int size : {1, 3}) {
        const std::string number = std::to_string(size);
        const PlacedScene placed = make_placed("gearbox:" + number);
        REQUIRE(placed.meshes.size() == 1);
        CHECK(placed.meshes[0].triangles.size() == 572);
        CHECK(placed.instances.size() == static_cast<std::size_t>(size * size * size));
        CHECK(placed.own.name == "gearbox:" + number);
        const Scene gears = make_builtin("gears:" + number), flat = make_builtin("gearbox:" + number);
        CHECK(primitive_count(placed) == gears.triangles.size());
        REQUIRE(flat.triangles.size() == gears.triangles.size());
        REQUIRE(flat.vertices.size() == gears.vertices.size());
        double off = 0;
        for (std::size_t i = 0; i < flat.vertices.size(); ++i)
            off = std::max(off, glm::length(flat.vertices[i] - gears.vertices[i]));
        CHECK(off < 1e-14);
        for (std::size_t i = 0; i < flat.triangles.size(); ++i) {
            REQUIRE(flat.triangles[i].vertex == gears.triangles[i].vertex);
            REQUIRE(flat.materials[flat.triangles[i].material].name ==
                    gears.materials[gears.triangles[i].material].name);
        }
    }
}

TEST_CASE("Other scenes have no instances, and are themselves when flattened", "[scene][placed]") {
    const PlacedScene placed = make_placed("gears:1");
    CHECK(placed.instances.empty());
    CHECK(flattened(placed).vertices == make_builtin("gears:1").vertices);
}
