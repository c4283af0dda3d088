// Meshes that deform by keyed shapes, compared with an independent formula; and refused files.
#include <catch2/catch.hpp>

#include <cmath>

#include <glm/geometric.hpp>

#include "sim/load/json/scene.hpp"
#include "tests/support/scenes/animated.hpp"
#include "tests/support/scenes/deforming_files.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

std::string shapes_json(const std::vector<std::pair<double, std::string>>& keys, const Json& objects) {
    Json json{{"meshes", {{"m", {{"shapes", Json::array()}}}}}, {"objects", objects}};
    for (const auto& [time, file] : keys)
        json["meshes"]["m"]["shapes"].push_back({{"time", time}, {"file", file}});
    return json.dump();
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n",
                  lifted = "v 0 0 1\nv 1 0 3\nv 2 1 0\nv 0 -1 0\nf 1 2 3 4\n";

}   // namespace

TEST_CASE(
    "every corner of a keyed shape moves straight from key to key, and stays still before and after them",
    "[motion][deform]") {
    const SceneFolder folder;
    folder.write("a.obj", square);
    folder.write("b.obj", lifted);
    folder.write("c.obj", square);
    PlacedScene scene = scene_in(folder.write(
        "s.json", shapes_json({{1, "a.obj"}, {2, "b.obj"}, {4, "c.obj"}}, {{{"mesh", "m"}, {"scale", 2}}})));
    REQUIRE(scene.meshes.size() == 1);
    REQUIRE(scene.instances.size() == 1);
    CHECK(scene.motion.length() == 4);
    const glm::dvec3 a[]{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
        b[]{{0, 0, 1}, {1, 0, 3}, {2, 1, 0}, {0, -1, 0}};
    for (const double t : {0.0, 1.0, 1.25, 2.0, 2.5, 3.9, 4.0, 9.0}) {
        pose(scene, t);
        const double s = t < 1 ? 0 : t < 2 ? t - 1 : t < 4 ? 1 - (t - 2) / 2 : 0;
        std::size_t seen = 0;
        for (const Corners& corners : corners_of(flat_copy(scene)))
            for (const glm::dvec3& corner : corners)
                for (int v = 0; v < 4; ++v)
                    seen += glm::length(corner - 2.0 * (a[v] * (1 - s) + b[v] * s)) < 1e-12;
        CHECK(seen == 6);
    }
}

TEST_CASE("normals of a keyed shape go from key to key, and facets have their own in every frame",
          "[motion][deform]") {
    const SceneFolder folder;
    const std::string faces = "f 1//1 2//1 3//1 4//2\n";
    folder.write("a.obj", square.substr(0, square.find('f')) + "vn 0 0 1\nvn 0 1 0\n" + faces);
    folder.write("b.obj", lifted.substr(0, lifted.find('f')) + "vn 0 3 0\nvn 1 0 0\n" + faces);
    PlacedScene smooth =
        scene_in(folder.write("s.json", shapes_json({{0, "a.obj"}, {1, "b.obj"}}, {{{"mesh", "m"}}})));
    pose(smooth, 0.25);
    REQUIRE(smooth.meshes[0].normals.size() == 4);
    for (const Triangle& t : smooth.meshes[0].triangles)
        for (const std::uint32_t v : t.vertex) {
            const bool is_last = glm::length(smooth.meshes[0].vertices[v] - glm::dvec3(0, 0.5, 0)) < 1e-9;
            const glm::dvec3 right =
                glm::normalize(is_last ? glm::dvec3(0.25, 0.75, 0) : glm::dvec3(0, 0.25, 0.75));
            CHECK(glm::length(smooth.meshes[0].normals[v] - right) < 1e-9);
        }
    // Next to smooth meshes a flat one gets the normals of its facets at each time.
    folder.write("c.obj", square);
    folder.write("d.obj", lifted);
    Json json = Json::parse(shapes_json({{0, "c.obj"}, {1, "d.obj"}}, {{{"mesh", "m"}}, {{"mesh", "n"}}}));
    json["meshes"]["n"] = {{"file", "a.obj"}};
    PlacedScene flat = scene_in(folder.write("f.json", json.dump()));
    for (const double time : {0.0, 0.5, 1.0}) {
        pose(flat, time);
        const SharedMesh& mesh = flat.meshes[0];
        REQUIRE(mesh.normals.size() == mesh.vertices.size());
        for (const Triangle& t : mesh.triangles) {
            const glm::dvec3 across = glm::cross(mesh.vertices[t.vertex[1]] - mesh.vertices[t.vertex[0]],
                                                 mesh.vertices[t.vertex[2]] - mesh.vertices[t.vertex[0]]);
            for (const std::uint32_t v : t.vertex)
                CHECK(glm::length(mesh.normals[v] - glm::normalize(across)) < 1e-9);
        }
    }
}

TEST_CASE("a facet takes no corner from a smooth neighbour", "[motion][deform]") {
    Deforming deforming;
    deforming.rest = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 0}};
    deforming.normals.assign(4, glm::dvec3(0, 0, 1));
    SharedMesh mesh{"two", deforming.rest, deforming.normals, {{{0, 1, 2}, 0}, {{0, 2, 3}, 0}}};
    make_faceted({0}, deforming, mesh);
    REQUIRE(mesh.vertices.size() == 6);
    const glm::dvec3 across = glm::normalize(glm::dvec3(-1, 1, 1));
    for (const std::uint32_t v : mesh.triangles[0].vertex)
        CHECK(glm::length(mesh.normals[v] - across) < 1e-9);
    for (const std::uint32_t v : mesh.triangles[1].vertex) CHECK(mesh.normals[v] == glm::dvec3(0, 0, 1));
    CHECK(mesh.vertices[mesh.triangles[1].vertex[1]] == glm::dvec3(1, 1, 0));
}

TEST_CASE("keyed shapes that do not fit together are refused with the file and the value",
          "[motion][deform]") {
    const SceneFolder folder;
    folder.write("a.obj", square);
    folder.write("b.obj", lifted);
    folder.write("more.obj", "v 0 0 0\n" + square);
    folder.write("faces.obj", square + "f 1 2 3\n");
    folder.write("other.obj", square.substr(0, square.find('f')) + "f 1 2 4 3\n");
    folder.write("fewer.obj", square.substr(0, square.find('f')) + "f 1 2 3\n");
    folder.write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    folder.write("ball.ply", Octahedron().ply_ascii());
    const auto with = [&](const std::vector<std::pair<double, std::string>>& keys) {
        return complaint(folder.write("s.json", shapes_json(keys, {{{"mesh", "m"}}})));
    };
    CHECK(with({{0, "a.obj"}, {1, "b.obj"}}).empty());
    check_says(with({{0, "a.obj"}, {1, "more.obj"}}),
               {"s.json", "meshes.m.shapes[1].file", "more.obj", "5 vertices", "a.obj", "has 4"});
    check_says(with({{0, "a.obj"}, {1, "b.obj"}, {2, "faces.obj"}}), {"shapes[2].file", "2 faces", "has 1"});
    check_says(with({{0, "a.obj"}, {1, "other.obj"}}), {"shapes[1].file", "face 1", "other vertices"});
    check_says(with({{0, "a.obj"}, {1, "fewer.obj"}}), {"face 1", "other vertices"});
    check_says(with({{0, "a.obj"}, {1, "nan.obj"}}), {"nan.obj", "line 1", "nan"});
    check_says(with({{0, "a.obj"}, {1, "absent.obj"}}), {"shapes[1].file", "absent.obj"});
    check_says(with({{0, "a.obj"}, {1, "ball.ply"}}), {"shapes[1].file", ".obj", "ball.ply"});
    check_says(with({{0, "a.obj"}, {0, "b.obj"}}), {"shapes[1].time", "is 0", "order"});
    check_says(with({{2, "a.obj"}, {1, "b.obj"}}), {"shapes[1].time", "is 1", "at 2"});
    check_says(with({{0, "a.obj"}}), {"meshes.m.shapes", "1 key", "two or more"});
    check_says(with({{-1, "a.obj"}, {1, "b.obj"}}), {"shapes[0].time", "-1"});
    Json both = Json::parse(shapes_json({{0, "a.obj"}, {1, "b.obj"}}, {{{"mesh", "m"}}}));
    both["meshes"]["m"]["file"] = "a.obj";
    check_says(complaint(folder.write("s.json", both.dump())), {"meshes.m", "one of", "'shapes'"});
}
