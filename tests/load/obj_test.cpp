// OBJ beyond plain triangles: polygons, negative indices, groups, materials.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "sim/load/mesh/triangulate.hpp"
#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test::obj_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

double area(const Corners& t) { return glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) / 2; }

/// Returns the sum of areas, and requires that all triangles face +z.
double upward_area(const Scene& scene) {
    double sum = 0;
    for (const Corners& t : corners_of(scene)) {
        CHECK(glm::cross(t[1] - t[0], t[2] - t[0]).z >= 0);
        sum += area(t);
    }
    return sum;
}

}   // namespace

TEST_CASE("polygons are cut without gaps or overlaps, concave ones too") {
    const SceneFolder folder;
    const std::string l_shape = "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\n";
    const Scene l = folder.load("l.obj", l_shape + "f 1 2 3 4 5 6\n");
    CHECK(l.triangles.size() == 4);
    CHECK(upward_area(l) == Approx(6));
    // Starting at every corner, and the arrowhead, whose dent must not be bridged.
    for (int first = 0; first < 6; ++first) {
        std::string face = "f";
        for (int k = 0; k < 6; ++k) face += std::string(" ") + std::to_string((first + k) % 6 + 1);
        CHECK(upward_area(folder.load("l.obj", l_shape + face + "\n")) == Approx(6));
    }
    // The same from below: everything is reversed.
    const Scene below = folder.load("l.obj", l_shape + "f 6 5 4 3 2 1\n");
    double signed_area = 0;
    for (const Corners& t : corners_of(below)) {
        CHECK(glm::cross(t[1] - t[0], t[2] - t[0]).z <= 0);
        signed_area += glm::cross(t[1] - t[0], t[2] - t[0]).z / 2;
    }
    CHECK(signed_area == Approx(-6));
    for (const std::string face : {"1 2 3 4", "2 3 4 1", "3 4 1 2", "4 1 2 3"}) {
        const Scene arrow =
            folder.load("arrow.obj", std::string("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf ") + face + "\n");
        CHECK(arrow.triangles.size() == 2);
        CHECK(upward_area(arrow) == Approx(1));
    }
    // Corners in the middle of straight edges.
    const Scene straight = folder.load(
        "s.obj",
        "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\nv 0 2 0\nv 0 1 0\nf 1 2 3 4 5 6 7 8\n");
    CHECK(straight.triangles.size() == 6);
    CHECK(upward_area(straight) == Approx(4));
}

TEST_CASE("random star-shaped polygons keep their area") {
    std::mt19937 random(7);
    for (int round = 0; round < 300; ++round) {
        const int n = 4 + static_cast<int>(random() % 40);
        std::vector<glm::dvec3> corners;
        double twice = 0;
        for (int i = 0; i < n; ++i) {
            const double angle = 6.283185307179586 * i / n,
                         radius = 0.1 + 0.9 * static_cast<double>(random() % 1000) / 1000;
            corners.emplace_back(radius * std::cos(angle), 5, -radius * std::sin(angle));
        }
        for (std::size_t i = 0; i < corners.size(); ++i)
            twice += glm::cross(corners[i], corners[(i + 1) % corners.size()]).y;
        std::vector<std::array<std::uint32_t, 3>> cut;
        triangulate(corners, cut);
        REQUIRE(cut.size() == corners.size() - 2);
        double sum = 0;
        for (const auto& [a, b, c] : cut)
            sum += glm::length(glm::cross(corners[b] - corners[a], corners[c] - corners[a]));
        INFO("round " << round << ", seed 7");
        CHECK(sum == Approx(twice).epsilon(1e-9));
    }
}

TEST_CASE("a face with thousands of corners loads, round or jagged") {
    const SceneFolder folder;
    for (const bool is_jagged : {false, true}) {
        const int n = 4000;
        std::string text, face = "f";
        for (int i = 0; i < n; ++i) {
            const double angle = 6.283185307179586 * i / n, radius = is_jagged && i % 2 ? 0.5 : 1;
            text += "v " + std::to_string(radius * std::cos(angle)) + ' ' +
                    std::to_string(radius * std::sin(angle)) + " 0\n";
            face += std::string(" ") + std::to_string(i + 1);
        }
        const Scene scene = folder.load("big.obj", text + face + "\n");
        CHECK(scene.triangles.size() == n - 2);
        CHECK(scene.vertices.size() == n);
        const double wedge = std::sin(6.283185307179586 / n) / 2;
        CHECK(upward_area(scene) == Approx(n * wedge * (is_jagged ? 0.5 : 1)).epsilon(1e-3));
    }
}

TEST_CASE("polygons without an inside still give n - 2 triangles") {
    std::vector<std::array<std::uint32_t, 3>> cut;
    triangulate(std::vector<glm::dvec3>(6, glm::dvec3(1)), cut);
    CHECK(cut.size() == 4);
    cut.clear();
    triangulate(std::vector<glm::dvec3>{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {1, 3, 0}}, cut);
    CHECK(cut.size() == 3);
}

TEST_CASE("negative indices count from their own line") {
    const SceneFolder folder;
    const Scene scene = folder.load(
        "n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\nf -1 -4 -3\nf 5 1 2\nv 7 7 7\n");
    REQUIRE(scene.triangles.size() == 3);
    CHECK(corners_of(scene)[0] == Corners{glm::dvec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(corners_of(scene)[1][0] == glm::dvec3(9));
    CHECK(corners_of(scene)[2][0] == glm::dvec3(7));
}

TEST_CASE("numbers in all their spellings arrive as the nearest 32-bit float") {
    const SceneFolder folder;
    const Scene scene = folder.load("n.obj",
                                    "v .5 -.5 +.25\nv 5. 1e2 1E-2\nv 0.1 -0 1e17\nv 1e-46 00.7 16777217\n"
                                    "v 0.30000000000000004 1234567.8901 -1e-320\nf 1 2 3\nf 3 4 5\n");
    REQUIRE(scene.triangles.size() == 2);
    std::vector<glm::dvec3> seen;
    for (const Corners& t : corners_of(scene)) seen.insert(seen.end(), t.begin(), t.end());
    const auto has = [&](double x, double y, double z) {
        const glm::dvec3 wanted(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
        return std::find(seen.begin(), seen.end(), wanted) != seen.end();
    };
    CHECK(has(0.5, -0.5, 0.25));
    CHECK(has(5, 100, 0.01));
    CHECK(has(0.1, 0, 1e17));
    CHECK(has(0, 0.7, 16777216));
    CHECK(has(0.3, 1234567.8901, 0));
    const std::string text =
        "solid\nfacet normal nan -nan inf\nouter loop\nvertex .5 -.5 +.25\nvertex 5. 1e2 1E-2\nvertex 0.1 -0 "
        "3e38\n"
        "endloop\nendfacet\nendsolid\n";
    CHECK(folder.load("n.stl", text).vertices[0] == glm::dvec3(0.5, -0.5, 0.25));
}

TEST_CASE("32-bit floats survive being written and read, in text formats as in binary ones") {
    const SceneFolder folder;
    std::mt19937 random(11);
    std::string obj, ply, stl = "solid\n";
    std::vector<glm::dvec3> written;
    for (int i = 0; i < 3000; ++i) {
        glm::dvec3 v;
        for (int k = 0; k < 3; ++k) {
            const double sign = random() % 2 ? 1 : -1;
            v[k] = static_cast<float>(sign *
                                      std::pow(10, -5 + 20 * static_cast<double>(random()) / 4294967296.0));
        }
        written.push_back(v);
        char text[100];
        std::snprintf(text, sizeof text, "%.9g %.9g %.9g\n", v.x, v.y, v.z);
        obj += std::string("v ") + text;
        ply += text;
        stl += (i % 3 ? "" : "facet normal 0 0 0\nouter loop\n") + (std::string("vertex ") + text) +
               (i % 3 == 2 ? "endloop\nendfacet\n" : "");
    }
    for (int i = 0; i < 3000; i += 3) {
        obj +=
            "f " + std::to_string(i + 1) + ' ' + std::to_string(i + 2) + ' ' + std::to_string(i + 3) + '\n';
        ply += "3 " + std::to_string(i) + ' ' + std::to_string(i + 1) + ' ' + std::to_string(i + 2) + '\n';
    }
    ply =
        "ply\nformat ascii 1.0\nelement vertex 3000\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1000\nproperty list uchar int vertex_index\nend_header\n" +
        ply;
    CHECK(folder.load("r.obj", obj).vertices == written);
    CHECK(folder.load("r.ply", ply).vertices == written);
    CHECK(folder.load("r.stl", stl + "endsolid\n").vertices == written);
}

TEST_CASE("a binary file may begin with a byte that looks like a line break") {
    const SceneFolder folder;
    Octahedron o;
    for (const char first : {'\n', '\r', ' ', '\t', '\0'}) {
        const std::string bits = {first, '\x10', '\x80', '\x3f'};
        float x = 0;
        std::memcpy(&x, bits.data(), sizeof x);
        o.vertices[0].x = x;
        CHECK(corners_of(folder.load("a.ply", o.ply_binary(false)))[0][0].x == x);
        CHECK(corners_of(folder.load("a.stl", o.stl_binary()))[0][0].x == x);
        CHECK(corners_of(folder.load("a.glb", o.glb()))[0][0].x == x);
    }
}

TEST_CASE("obj: groups, objects, points, lines, textures and continued lines change no face") {
    const SceneFolder folder;
    const std::string v = "v 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nv 0 0 1\nvt 0 0\n";
    const Scene scene = folder.load(
        "g.obj", v + "o first\ng a b\nf 1/1 2/1 3/1\ng c\nf 2 3 4\ns off\ng a b\np 1\nl 1 2 3\nf 1 2\n"
                     "f 1/1/ \\\n2/9/ 4 # the last\n");
    REQUIRE(scene.triangles.size() == 3);
    CHECK(corners_of(scene)[2] == Corners{glm::dvec3{0, 0, 0}, {1, 0, 0}, {0, 0, 1}});
}

TEST_CASE("faces keep the order of the file through groups and materials") {
    const SceneFolder folder;
    std::string text = "  v 0 0 0\n\tv 1 0 0\nv 0 1 0\n";
    const int count = 60;
    for (int i = 0; i < count; ++i) text += std::string("v 0 0 ") + std::to_string(i + 1) + "\n";
    const char* groups[] = {"g one\n", "o two\n", "usemtl red\n", "usemtl blue stone\n"};
    for (int i = 0; i < count; ++i)
        text += groups[i * 7 % 4] + (std::string("f 1 2 \\\n ") + std::to_string(i + 4) + "\n");
    const Scene scene = folder.load("order.obj", text);
    REQUIRE(scene.triangles.size() == count);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 expected(0, 0, static_cast<double>(i + 1));
        const Corners t = corners_of(scene)[i];
        CHECK(std::find(t.begin(), t.end(), expected) != t.end());
    }
    std::vector<std::string> names;
    for (const Material& m : scene.materials) names.push_back(m.name);
    std::sort(names.begin(), names.end());
    CHECK(names == std::vector<std::string>{"blue stone", "default", "red"});
}

TEST_CASE("mtl: colours, highlights and transparency are read, and a missing material is grey") {
    const SceneFolder folder;
    folder.write(
        "my colours.mtl",
        "# colours\nnewmtl clay\nKa 1 1 1\nKd 0.5 0.25 0.125\nillum 1\nKs 1 1 1\nmap_Kd nothing.png\n"
        "newmtl glass ball\nKd 0.25 0.25 0.25\nKs 0.5 0.25 0.25\nNs 64\nd 0.25\nNi 1.5\nillum 2\n"
        "newmtl mirror\nKd 0 0 0\nKs 0.75 0.75 0.75\nTr 0\nillum 3\nnewmtl unused\nKd 1 1 1\n");
    const Scene scene = folder.load(
        "m.obj",
        "mtllib my colours.mtl\nmtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl clay\nf 1 2 3\n"
        "usemtl glass ball\nf 1 3 2\nusemtl mirror\nf 2 1 3\nusemtl nowhere\nf 3 2 1\n");
    REQUIRE(scene.triangles.size() == 4);
    REQUIRE(scene.materials.size() == 4);
    const auto of = [&](std::size_t t) { return scene.materials[scene.triangles[t].material]; };
    CHECK(of(0).name == "clay");
    CHECK(of(0).colour == glm::dvec3(0.5, 0.25, 0.125));
    CHECK(of(0).highlight == 0);
    CHECK(of(0).transmit == 0);
    CHECK(of(1).name == "glass ball");
    CHECK(of(1).highlight == 0.5);
    CHECK(of(1).shine == 64);
    CHECK(of(1).transmit == 0.75);
    CHECK(of(1).index == 1.5);
    CHECK(of(1).mirror == 0);
    CHECK(of(2).mirror == 0.75);
    CHECK(of(3).name == "nowhere");
    CHECK(of(3).colour.x == Approx(0.8));
}

}   // namespace rayclock::test::obj_test
