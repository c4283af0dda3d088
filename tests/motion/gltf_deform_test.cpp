// Deforming meshes of glTF: compares morph targets and skins with independent formulas in double.
#include <catch2/catch.hpp>

#include "tests/support/scenes/gltf_deforming.hpp"

using namespace rayclock;
using namespace rayclock::test;

TEST_CASE("glTF: morph targets are added with their weights, which move", "[motion][deform]") {
    Morphed file;
    file.json["meshes"][0]["weights"] = {0.5, 0};
    CHECK(file.load().motion.empty());   // another shape than the stored one, but constant
    file.check(file.load().meshes.at(0), 0.5, 0);
    file.json["nodes"][0]["weights"] = {0, 0.25};   // the node's weights take precedence
    file.check(file.load().meshes.at(0), 0, 0.25);
    file.json["nodes"][0]["weights"] = {0, 0};
    CHECK(file.load().meshes.empty());   // nothing moves
    file.channel(0, "weights", {0, 1, 3}, {0, 1, 0.5f, 0, 1, -1});
    PlacedScene scene = file.load();
    REQUIRE(scene.meshes.size() == 1);
    for (const double t : {0.0, 0.25, 1.0, 2.0, 5.0}) {
        pose(scene, t);
        file.check(scene.meshes[0], t < 1 ? t / 2 : std::min(0.5 + (t - 1) / 4, 1.0),
                   t < 1 ? 1 - t : std::max(-(t - 1) / 2, -1.0));
    }
    Morphed jumps;
    jumps.channel(0, "weights", {0, 1}, {0.5f, 1, 0, -1}, "STEP");
    scene = jumps.load();
    pose(scene, 0.9);
    jumps.check(scene.meshes[0], 0.5, 1);
    pose(scene, 1);
    jumps.check(scene.meshes[0], 0, -1);
    // In tangents, values and out tangents for both targets: from 0 to 1 with slopes 2 and 0.
    Morphed curves;
    curves.channel(0, "weights", {0, 2}, {0, 0, 0, 1, 2, 0, 0, 0, 1, 1, 0, 0}, "CUBICSPLINE");
    scene = curves.load();
    for (const double t : {0.0, 0.5, 1.0, 1.5, 2.0}) {
        const double s = t / 2;
        pose(scene, t);
        curves.check(scene.meshes[0], 2 * 2 * (s * s * s - 2 * s * s + s) + 3 * s * s - 2 * s * s * s, 1);
    }
}

TEST_CASE("glTF: normals of morph targets are added, and are unit vectors", "[motion][deform]") {
    Morphed file(true);
    file.channel(0, "weights", {0, 1}, {0, 0, 1, 1});
    PlacedScene scene = file.load();
    pose(scene, 0.5);
    REQUIRE(scene.meshes[0].normals.size() == 6);
    for (std::size_t v = 0; v < 6; ++v) {
        const glm::dvec3 right =
            glm::normalize(file.triple(file.normals, v) + 0.5 * file.triple(file.turns, v));
        CHECK(glm::length(scene.meshes[0].normals[v] - right) < 1e-9);
    }
}

TEST_CASE("glTF: a part without normals has facets next to a smooth one of the same mesh",
          "[motion][deform]") {
    Morphed file(true);
    Json flat = file.json["meshes"][0]["primitives"][0];
    flat["attributes"].erase("NORMAL"), flat["targets"][1].erase("NORMAL");
    file.json["meshes"][0]["primitives"].push_back(flat);
    file.channel(0, "weights", {0, 1}, {0, 0, 1, 1});
    PlacedScene scene = file.load();
    pose(scene, 0.5);
    const SharedMesh& mesh = scene.meshes[0];
    REQUIRE(mesh.triangles.size() == 16);
    REQUIRE(mesh.vertices.size() == 6 + 3 * 8);
    REQUIRE(mesh.normals.size() == mesh.vertices.size());
    for (std::size_t t = 0; t < 16; ++t) {
        std::array<glm::dvec3, 3> p{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t v = std::size_t(Octahedron().triangles[t % 8][k]);
            p[k] = file.rest(v) + 0.5 * (file.triple(file.to, v) + file.triple(file.more, v));
            CHECK(glm::length(mesh.vertices[mesh.triangles[t].vertex[k]] - p[k]) < 1e-9);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t v = std::size_t(Octahedron().triangles[t % 8][k]);
            const glm::dvec3 right = t < 8 ? file.triple(file.normals, v) + 0.5 * file.triple(file.turns, v)
                                           : glm::cross(p[1] - p[0], p[2] - p[0]);
            const glm::dvec3 normal = mesh.normals[mesh.triangles[t].vertex[k]];
            CHECK(glm::length(normal - glm::normalize(right)) < 1e-9);
        }
    }
}

TEST_CASE("glTF: joints carry a skin by their places and inverse binds, and its node does not",
          "[motion][deform]") {
    const Skinned file;
    PlacedScene scene = file.load();
    REQUIRE(scene.meshes.size() == 1);
    REQUIRE(scene.instances.size() == 1);
    for (const double t : {0.0, 0.4, 1.0, 1.7, 2.0}) {
        pose(scene, t);
        CHECK(scene.instances[0].place == glm::dmat4(1));
        for (std::size_t v = 0; v < 6; ++v)
            CHECK(glm::length(scene.meshes[0].vertices[v] - file.right(v, t, Octahedron().vertices[v])) <
                  2e-5);
    }
    // Without matrices the resting mesh is at the middle of its joints. At rest forever, nothing moves.
    Skinned still = file;
    still.json.erase("animations");
    still.json["skins"][0].erase("inverseBindMatrices");
    still.bind = {unit(), unit()};
    scene = still.load();
    CHECK(scene.motion.empty());
    for (std::size_t v = 0; v < 6; ++v)
        CHECK(glm::length(scene.meshes.at(0).vertices[v] - still.right(v, 0, Octahedron().vertices[v])) <
              2e-5);
}

TEST_CASE("glTF: a skin carries what its morph targets have made", "[motion][deform]") {
    Skinned file;
    std::vector<float> up;
    for (int v = 0; v < 6; ++v) up.insert(up.end(), {0, float(v), 0});
    file.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", file.accessor(up, "VEC3", 3)}}};
    file.channel(3, "weights", {0, 2}, {0, 1});
    PlacedScene scene = file.load();
    pose(scene, 1);
    for (std::size_t v = 0; v < 6; ++v) {
        const glm::dvec3 rest = Octahedron().vertices[v] + glm::dvec3(0, 0.5 * double(v), 0);
        CHECK(glm::length(scene.meshes[0].vertices[v] - file.right(v, 1, rest)) < 2e-5);
    }
}

TEST_CASE("a file with a skin deforms where it is placed, in every place alike", "[motion][deform]") {
    const SceneFolder folder;
    const Skinned file;
    folder.write("skin.glb", glb_of(file.json.dump(), file.bytes));
    folder.write(
        "inner.json",
        R"({"meshes": {"s": {"file": "skin.glb"}}, "objects": [{"mesh": "s", "translate": [0, 7, 0]}]})");
    PlacedScene scene = scene_in(folder.write("outer.json", R"({
      "meshes": {"s": {"file": "skin.glb"}, "i": {"file": "inner.json"}},
      "objects": [{"mesh": "s", "keyframes": [{"time": 0, "translate": [0, 0, 0]}, {"time": 2, "translate": [8, 0, 0]}]},
                  {"mesh": "s", "scale": 3}, {"mesh": "i", "translate": [0, 0, 1]}]})"));
    REQUIRE(scene.instances.size() == 3);
    pose(scene, 1);
    for (std::size_t v = 0; v < 6; ++v) {
        const glm::dvec3 right = file.right(v, 1, Octahedron().vertices[v]);
        const glm::dvec3 places[]{right + glm::dvec3(4, 0, 0), 3.0 * right, right + glm::dvec3(0, 7, 1)};
        for (std::size_t i = 0; i < 3; ++i) {
            const Instance& instance = scene.instances[i];
            const glm::dvec3 own =
                glm::dvec3(instance.place * glm::dvec4(scene.meshes[instance.mesh].vertices[v], 1));
            CHECK(glm::length(own - places[i]) < 1e-4);
        }
    }
}

TEST_CASE("glTF: sparse morph targets are read as exporters write them", "[motion][deform]") {
    Sparse file;
    file.check(file.load().meshes.at(0), 0.5, 0);
    // The same on top of data in a buffer.
    file.json["accessors"][file.number]["bufferView"] = 0;
    for (std::size_t v = 0; v < 6; ++v)
        for (int k = 0; v != 1 && v != 5 && k < 3; ++k)
            file.to[3 * v + std::size_t(k)] = float(file.rest(v)[k]);
    file.check(file.load().meshes.at(0), 0.5, 0);
    check_says(says(Sparse{}, [](Sparse& f) { f.sparse()["count"] = 7; }),
               {"accessors", "sparse.count", "7"});
    check_says(says(Sparse{}, [](Sparse& f) { f.sparse()["count"] = 3; }), {"sparse", "needs"});
    check_says(says(Sparse{}, [](Sparse& f) { f.sparse()["indices"]["componentType"] = 5126; }),
               {"sparse.indices.componentType", "5126"});
    check_says(says(Sparse{},
                    [](Sparse& f) {
                        const std::size_t at = f.byte_accessor({"\5\1\0\0", 4});
                        f.sparse()["indices"]["bufferView"] = f.json["accessors"][at]["bufferView"];
                    }),
               {"sparse.indices", "element 1 at 1", "rise"});
    check_says(says(Sparse{},
                    [](Sparse& f) {
                        const std::size_t at = f.byte_accessor({"\1\6\0\0", 4});
                        f.sparse()["indices"]["bufferView"] = f.json["accessors"][at]["bufferView"];
                    }),
               {"sparse.indices", "element 6 at 1", "there are 6"});
}
