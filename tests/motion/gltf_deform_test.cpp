// Meshes of glTF that deform: morph targets and skins, against formulas of their own in double; and what is
// refused.
#include <catch2/catch.hpp>

#include <cmath>

#include <glm/geometric.hpp>

#include "model/base/rng.hpp"
#include "tests/motion/animated.hpp"
#include "tests/motion/shapes.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Rows and columns as in books; nothing of GLM.
using Matrix = std::array<std::array<double, 4>, 4>;
Matrix unit() {
    Matrix m{};
    for (std::size_t i = 0; i < 4; ++i) m[i][i] = 1;
    return m;
}
Matrix times(const Matrix& a, const Matrix& b) {
    Matrix m{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t j = 0; j < 4; ++j) m[i][k] += a[i][j] * b[j][k];
    return m;
}
Matrix moved(double x, double y, double z) {
    Matrix m = unit();
    m[0][3] = x, m[1][3] = y, m[2][3] = z;
    return m;
}
Matrix scaled(double x, double y, double z) {
    Matrix m = unit();
    m[0][0] = x, m[1][1] = y, m[2][2] = z;
    return m;
}
Matrix about_z(double radians) {
    Matrix m = unit();
    m[0][0] = m[1][1] = std::cos(radians);
    m[1][0] = std::sin(radians), m[0][1] = -m[1][0];
    return m;
}
glm::dvec3 of(const Matrix& m, const glm::dvec3& p) {
    glm::dvec3 out;
    for (std::size_t i = 0; i < 3; ++i) out[int(i)] = m[i][0] * p.x + m[i][1] * p.y + m[i][2] * p.z + m[i][3];
    return out;
}
std::vector<float> columns(const std::vector<Matrix>& all) {
    std::vector<float> numbers;
    for (const Matrix& m : all)
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t i = 0; i < 4; ++i) numbers.push_back(float(m[i][k]));
    return numbers;
}

/// The octahedron with two morph targets, and normals that point away from its middle.
struct Morphed : Animated {
    std::vector<float> to, more, normals, turns;

    explicit Morphed(bool is_smooth = false) {
        Rng rng{31};
        for (std::size_t i = 0; i < 18; ++i) {
            to.push_back(float(rng.below(100)) / 64 - 0.5f);
            more.push_back(float(rng.below(100)) / 16);
            normals.push_back(i % 3 == i / 3 % 3 ? (i / 9 ? -1.0f : 1.0f) : 0.0f);
            turns.push_back(float(rng.below(100)) / 100);
        }
        Json& primitive = json["meshes"][0]["primitives"][0];
        primitive["targets"] = {{{"POSITION", accessor(to, "VEC3", 3)}},
                                {{"POSITION", accessor(more, "VEC3", 3)}}};
        if (!is_smooth) return;
        primitive["attributes"]["NORMAL"] = accessor(normals, "VEC3", 3);
        primitive["targets"][1]["NORMAL"] = accessor(turns, "VEC3", 3);
    }
    glm::dvec3 rest(std::size_t v) const { return Octahedron().vertices[v]; }
    static glm::dvec3 triple(const std::vector<float>& list, std::size_t v) {
        return {list[3 * v], list[3 * v + 1], list[3 * v + 2]};
    }
    void check(const SharedMesh& mesh, double first, double second) const {
        REQUIRE(mesh.vertices.size() == 6);
        for (std::size_t v = 0; v < 6; ++v) {
            const glm::dvec3 right = rest(v) + first * triple(to, v) + second * triple(more, v);
            CHECK(glm::length(mesh.vertices[v] - right) < 1e-9);
        }
    }
};

/// The octahedron on two joints, of which the second hangs at the first and turns; above both stands a node
/// that stretches them, and the node with the mesh stands somewhere else.
struct Skinned : Animated {
    std::vector<Matrix> bind{times(moved(-1, 0.5, 0), scaled(0.5, 1, 2)), moved(0, -2, 1)};
    std::vector<double> share{1, 0, 0.25, 0.5, 0.75, 0.125};   // of the first joint

    Skinned() {
        json["nodes"] = {{{"children", {1, 3}}},
                         {{"children", {2}}, {"scale", {1, 2, 1}}, {"translation", {0, 0, 5}}},
                         {{"children", {4}}, {"translation", {1, 2, 3}}},
                         {{"mesh", 0}, {"skin", 0}, {"translation", {100, 100, 100}}},
                         {{"translation", {0, 1, 0}}}};
        json["skins"] = {{{"joints", {2, 4}}, {"inverseBindMatrices", accessor(columns(bind), "MAT4", 16)}}};
        std::string joints;
        std::vector<float> weights;
        for (const double s : share) {
            joints += std::string("\1\0\0\1", 4);   // the second, the first, nothing, the second again
            weights.insert(weights.end(), {float(0.75 * (1 - s)), float(s), 0, float(0.25 * (1 - s))});
        }
        Json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
        attributes["WEIGHTS_0"] = accessor(weights, "VEC4", 4);
        attributes["JOINTS_0"] = byte_accessor(joints);
        channel(4, "rotation", {0, 2}, {0, 0, 0, 1, 0, 0, 1, 0});   // half a turn about z
    }
    /// Of both joints, with their way to the mesh at rest.
    std::vector<Matrix> joints(double time) const {
        const Matrix first = times(times(moved(0, 0, 5), scaled(1, 2, 1)), moved(1, 2, 3)),
                     second = times(times(first, moved(0, 1, 0)), about_z(M_PI / 2 * time));
        return {times(first, bind[0]), times(second, bind[1])};
    }
    glm::dvec3 right(std::size_t v, double time, const glm::dvec3& rest) const {
        const std::vector<Matrix> both = joints(time);
        return share[v] * of(both[0], rest) + (1 - share[v]) * of(both[1], rest);
    }
};

/// The sentence with which a file is refused whose document was changed.
template <class File, class Change> std::string says(File file, const Change& change) {
    change(file);
    return file.says();
}

}   // namespace

TEST_CASE("glTF: morph targets are added with their weights, which move", "[motion][deform]") {
    Morphed file;
    file.json["meshes"][0]["weights"] = {0.5, 0};
    CHECK(file.load().motion.empty());   // another shape than the stored one, but always the same
    file.check(file.load().meshes.at(0), 0.5, 0);
    file.json["nodes"][0]["weights"] = {0, 0.25};   // of the node, and they go first
    file.check(file.load().meshes.at(0), 0, 0.25);
    file.json["nodes"][0]["weights"] = {0, 0};
    CHECK(file.load().meshes.empty());   // nothing of it moves
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
    // In tangents, values, out tangents, of both targets each: from 0 to 1 with slopes 2 and 0.
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
    // Without matrices the mesh at rest stands at its joints' middle; at rest for ever, nothing moves.
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
    const Folder folder;
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

TEST_CASE("glTF: bad skins are refused with the vertex, the joint and the value", "[motion][deform]") {
    const auto attributes = [](Animated& f) -> Json& {
        return f.json["meshes"][0]["primitives"][0]["attributes"];
    };
    const auto weights = [&](float a, float b) {
        return says(Skinned{}, [&](Skinned& f) {
            std::vector<float> all;
            for (int v = 0; v < 6; ++v) all.insert(all.end(), {v == 3 ? a : 1, v == 3 ? b : 0, 0, 0});
            attributes(f)["WEIGHTS_0"] = f.accessor(all, "VEC4", 4);
        });
    };
    CHECK(weights(0.5f, 0.5f).empty());
    CHECK(weights(0.5f, 0.49f).empty());   // rounded, as bytes are
    check_says(weights(0.5f, 0.25f),
               {"a.glb", "meshes[0].primitives[0].attributes.WEIGHTS_0", "0.75", "vertex 3"});
    check_says(weights(0, 0), {"sums to 0", "vertex 3"});
    check_says(weights(-0.5f, 1.5f), {"weight -0.5", "vertex 3"});
    check_says(weights(NAN, 1), {"weight nan", "vertex 3"});
    check_says(says(Skinned{}, [&](Skinned& f) { attributes(f).erase("JOINTS_0"); }),
               {"attributes", "JOINTS_0", "nodes[3]", "skin"});
    check_says(says(Skinned{}, [&](Skinned& f) { attributes(f).erase("WEIGHTS_0"); }),
               {"WEIGHTS_0", "nodes[3]"});
    check_says(says(Skinned{},
                    [&](Skinned& f) {
                        std::string joints(24, '\0');
                        joints[10] = '\2';
                        attributes(f)["JOINTS_0"] = f.byte_accessor(joints);
                    }),
               {"JOINTS_0", "joint 2", "vertex 2", "out of range", "has 2"});
    check_says(says(Skinned{},
                    [&](Skinned& f) { attributes(f)["JOINTS_0"] = f.byte_accessor(std::string(20, '\0')); }),
               {"JOINTS_0", "5 elements for 6 vertices"});
    check_says(says(Skinned{}, [](Skinned& f) { f.json["nodes"][3]["skin"] = 1; }), {"nodes[3].skin", "1"});
    check_says(says(Skinned{},
                    [](Skinned& f) {
                        f.json["skins"][0]["joints"] = {2, 9};
                    }),
               {"skins[0].joints[1]", "9"});
    check_says(says(Skinned{}, [](Skinned& f) { f.json["skins"][0]["joints"] = Json::array(); }),
               {"skins[0].joints", "empty"});
    check_says(says(Skinned{},
                    [](Skinned& f) {
                        f.json["skins"][0]["joints"] = {2, 4, 2};
                    }),
               {"inverseBindMatrices", "2 matrices for 3 joints"});
    check_says(says(Skinned{}, [](Skinned& f) { f.json["nodes"][1]["children"] = Json::array(); }),
               {"skins[0].joints[0]", "nodes[2]", "scene"});
    check_says(says(Skinned{},
                    [](Skinned& f) {
                        f.bind[1][0][3] = NAN;
                        f.json["skins"][0]["inverseBindMatrices"] = f.accessor(columns(f.bind), "MAT4", 16);
                    }),
               {"accessors", "nan", "matrix 1"});
    check_says(says(Skinned{},
                    [](Skinned& f) {
                        f.bind[1][0][0] = 1e29;
                        f.json["skins"][0]["inverseBindMatrices"] = f.accessor(columns(f.bind), "MAT4", 16);
                        f.json["nodes"][1]["scale"] = {1e10, 1, 1};
                    }),
               {"nodes[3]", "at 0 s", "vertex 1", "finite"});
}

namespace {

/// A morph target that moves the second vertex and the last by (1, 2, 3) and (4, 5, 6), and no other.
struct Sparse : Morphed {
    Sparse() {
        const std::size_t values = accessor({1, 2, 3, 4, 5, 6}, "VEC3", 3),
                          at = byte_accessor({"\1\5\0\0", 4});
        json["accessors"][values]["count"] = 6;
        Json& target = json["accessors"][values];
        target["sparse"] = {
            {"count", 2},
            {"indices", {{"bufferView", json["accessors"][at]["bufferView"]}, {"componentType", 5121}}},
            {"values", {{"bufferView", target["bufferView"]}}}};
        target.erase("bufferView");
        number = values;
        json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] = values;
        to.assign(18, 0);
        for (std::size_t i = 0; i < 3; ++i) to[3 + i] = float(i + 1), to[15 + i] = float(i + 4);
        json["nodes"][0]["weights"] = {0.5, 0};
    }
    Json& sparse() { return json["accessors"][number]["sparse"]; }
    std::size_t number = 0;
};

}   // namespace

TEST_CASE("glTF: sparse morph targets, as exporters write them", "[motion][deform]") {
    Sparse file;
    file.check(file.load().meshes.at(0), 0.5, 0);
    // The same over what lies in a buffer.
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

TEST_CASE("glTF: bad morph targets are refused with the node and the value", "[motion][deform]") {
    const auto primitive = [](Animated& f) -> Json& { return f.json["meshes"][0]["primitives"][0]; };
    check_says(says(Morphed{},
                    [](Morphed& f) {
                        f.channel(0, "weights", {0, 1}, {0, 0, 1});
                    }),
               {"samplers[0]", "3 values for 2 times and 2 morph targets"});
    check_says(says(Morphed{},
                    [](Morphed& f) {
                        f.channel(0, "weights", {1, 0}, {0, 0, 1, 1});
                    }),
               {"time 0", "rise"});
    check_says(says(Morphed{},
                    [](Morphed& f) {
                        f.channel(0, "weights", {0, 1}, {0, 0, NAN, 1});
                    }),
               {"nan", "element 2", "weight"});
    check_says(says(Animated{},
                    [](Animated& f) {
                        f.channel(0, "weights", {0, 1}, {0, 1});
                    }),
               {"channels[0].target", "nodes[0]", "no morph targets"});
    check_says(says(Morphed{},
                    [](Morphed& f) {
                        for (int i = 0; i < 2; ++i) f.channel(0, "weights", {0, 1}, {0, 0, 1, 1});
                    }),
               {"channels[1].target", "before this one"});
    check_says(says(Morphed{}, [](Morphed& f) { f.json["nodes"][0]["weights"] = {1}; }),
               {"nodes[0].weights", "1 weights for 2 morph targets"});
    check_says(says(Morphed{},
                    [&](Morphed& f) {
                        f.json["nodes"][0]["weights"] = {1, 0};
                        primitive(f)["targets"][1]["POSITION"] = f.accessor({1, 2, 3, 4, 5, 6}, "VEC3", 3);
                    }),
               {"targets[1].POSITION", "2 elements for 6 vertices"});
    check_says(says(Morphed{},
                    [&](Morphed& f) {
                        f.json["nodes"][0]["weights"] = {1, 0};
                        f.to[4] = INFINITY;
                        primitive(f)["targets"][0]["POSITION"] = f.accessor(f.to, "VEC3", 3);
                    }),
               {"accessors", "inf", "element 1"});
    check_says(says(Morphed{},
                    [&](Morphed& f) {
                        f.json["nodes"][0]["weights"] = {1, 0};
                        Json second = primitive(f);
                        second["targets"].erase(1);
                        f.json["meshes"][0]["primitives"].push_back(second);
                    }),
               {"primitives[1]", "1 morph targets", "has 2"});
    Morphed far;
    far.more[0] = 1e30f;
    Json& targets = primitive(far)["targets"];
    targets[1]["POSITION"] = far.accessor(far.more, "VEC3", 3);
    far.channel(0, "weights", {0, 1}, {0, 0, 0, 1e20f});
    PlacedScene scene = far.load();
    CHECK_THROWS_WITH(pose(scene, 1), Catch::Contains("nodes[0] at 1 s") && Catch::Contains("vertex 0"));
}
