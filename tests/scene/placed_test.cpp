// Scenes made of instances.
#include <catch2/catch.hpp>

#include <array>

#include <glm/geometric.hpp>

#include "model/scene/placed.hpp"

using namespace rayclock;

namespace {

/// Requires that the flattened scene has the same triangles with the same materials and numbers, and corners
/// equal up to double rounding.
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

TEST_CASE("the gearbox is one gear in many places, and the same as the gears", "[scene][placed]") {
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

TEST_CASE("the flake is one ball in many places, and the same as the balls", "[scene][placed]") {
    const PlacedScene placed = make_placed("flake:2");
    REQUIRE(placed.meshes.size() == 1);
    CHECK(placed.meshes[0].triangles.size() == 108);
    CHECK(placed.instances.size() == 1 + 9 + 81);
    check_same(placed, make_builtin("balls:2"), make_builtin("flake:2"));
}

TEST_CASE("the boughs are one cone and one ball in many places, and the same as the tree",
          "[scene][placed]") {
    const PlacedScene placed = make_placed("boughs:6");
    REQUIRE(placed.meshes.size() == 2);
    CHECK(placed.meshes[0].triangles.size() == 24);
    CHECK(placed.instances.size() == 2 * 127);
    check_same(placed, make_builtin("tree:6"), make_builtin("boughs:6"));
}

TEST_CASE("other scenes have no instances, and are themselves when flattened", "[scene][placed]") {
    const PlacedScene placed = make_placed("gears:1");
    CHECK(placed.instances.empty());
    CHECK(flattened(placed).vertices == make_builtin("gears:1").vertices);
}

TEST_CASE("normals stay perpendicular to their facets and on their side, whatever the map",
          "[scene][placed]") {
    // Each facet has its own corners and corner normals. The map scales unequally, shears, turns, and in half
    // of the cases mirrors.
    PlacedScene scene;
    scene.own.materials = {Material{}};
    SharedMesh mesh;
    const std::array<glm::dvec3, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.3, 1}}};
    const std::array<std::array<std::size_t, 3>, 4> facets{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    for (const auto& facet : facets) {
        const glm::dvec3 a = corners[facet[0]], b = corners[facet[1]], c = corners[facet[2]];
        const auto first = std::uint32_t(mesh.vertices.size());
        mesh.triangles.push_back({{first, first + 1, first + 2}, 0});
        mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
        mesh.normals.insert(mesh.normals.end(), 3, glm::normalize(glm::cross(b - a, c - a)));
    }
    scene.meshes = {mesh};
    const double mirror = GENERATE(1, -1);
    glm::dmat4 place(1);
    place[0] = {0.8 * mirror, 0.3 * mirror, 0.1 * mirror, 0};
    place[1] = {0.7, 2, -0.4, 0};
    place[2] = {-0.2, 0.5, 0.3, 0};
    place[3] = {5, -3, 2, 1};
    scene.instances = {{"placed", 0, place, std::nullopt}};
    const Scene flat = flattened(scene);
    const auto moved = [&](const glm::dvec3& p) { return glm::dvec3(place * glm::dvec4(p, 1)); };
    const glm::dvec3 inside = moved({0.3, 0.3, 0.2});
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const auto& vertex = flat.triangles[i].vertex;
        const glm::dvec3 a = flat.vertices[vertex[0]], b = flat.vertices[vertex[1]],
                         c = flat.vertices[vertex[2]], out = glm::normalize(glm::cross(b - a, c - a));
        CHECK(glm::dot(out, a - inside) > 0);   // the order of corners defines the outside
        for (const std::uint32_t v : vertex) CHECK(glm::length(flat.normals[v] - out) < 1e-12);
    }
}
