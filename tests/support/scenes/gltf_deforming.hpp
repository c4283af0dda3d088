#pragma once
// Deforming meshes of glTF, and their correct shapes by independent formulas in double.
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/base/rng.hpp"
#include "tests/support/scenes/animated.hpp"
#include "tests/support/scenes/deforming_files.hpp"

namespace rayclock::test {

/// Rows and columns as in textbooks; uses nothing of GLM.
using Matrix = std::array<std::array<double, 4>, 4>;
inline Matrix unit() {
    Matrix m{};
    for (std::size_t i = 0; i < 4; ++i) m[i][i] = 1;
    return m;
}
inline Matrix times(const Matrix& a, const Matrix& b) {
    Matrix m{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t j = 0; j < 4; ++j) m[i][k] += a[i][j] * b[j][k];
    return m;
}
inline Matrix moved(double x, double y, double z) {
    Matrix m = unit();
    m[0][3] = x, m[1][3] = y, m[2][3] = z;
    return m;
}
inline Matrix scaled(double x, double y, double z) {
    Matrix m = unit();
    m[0][0] = x, m[1][1] = y, m[2][2] = z;
    return m;
}
inline Matrix about_z(double radians) {
    Matrix m = unit();
    m[0][0] = m[1][1] = std::cos(radians);
    m[1][0] = std::sin(radians), m[0][1] = -m[1][0];
    return m;
}
inline glm::dvec3 of(const Matrix& m, const glm::dvec3& p) {
    glm::dvec3 out;
    for (std::size_t i = 0; i < 3; ++i) out[int(i)] = m[i][0] * p.x + m[i][1] * p.y + m[i][2] * p.z + m[i][3];
    return out;
}
inline std::vector<float> columns(const std::vector<Matrix>& all) {
    std::vector<float> numbers;
    for (const Matrix& m : all)
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t i = 0; i < 4; ++i) numbers.push_back(float(m[i][k]));
    return numbers;
}

/// The octahedron with two morph targets, and normals that point away from its centre.
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

/// The octahedron on two joints. The second is a child of the first and rotates. A node above both stretches
/// them, and the node with the mesh is elsewhere.
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
            joints += std::string("\1\0\0\1", 4);   // the second, the first, none, the second again
            weights.insert(weights.end(), {float(0.75 * (1 - s)), float(s), 0, float(0.25 * (1 - s))});
        }
        Json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
        attributes["WEIGHTS_0"] = accessor(weights, "VEC4", 4);
        attributes["JOINTS_0"] = byte_accessor(joints);
        channel(4, "rotation", {0, 2}, {0, 0, 0, 1, 0, 0, 1, 0});   // half a turn about z
    }
    /// Returns the matrices of both joints, including their inverse binds.
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

/// Returns the message with which the changed file is refused.
template <class File, class Change> std::string says(File file, const Change& change) {
    change(file);
    return file.says();
}

/// A morph target that moves only the second vertex by (1, 2, 3) and the last by (4, 5, 6).
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

}   // namespace rayclock::test
