// One mesh in every format: the same triangles in the same order, bit by bit.
#include <catch2/catch.hpp>

#include <glm/geometric.hpp>

#include "tests/support/scenes/scene_files.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Assimp may start a triangle at another corner; the orientation must stay.
std::vector<Corners> rotated(std::vector<Corners> all) {
    const auto less = [](const glm::dvec3& a, const glm::dvec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    for (Corners& t : all) std::rotate(t.begin(), std::min_element(t.begin(), t.end(), less), t.end());
    return all;
}

void check_octahedron(const Scene& scene) {
    CHECK(rotated(corners_of(scene)) == rotated(Octahedron().corners()));
    CHECK(scene.vertices.size() == 6);
    CHECK(scene.normals.empty());
    CHECK(scene.materials.size() == 1);
    CHECK(scene.materials.front().name == "default");
    CHECK(scene.lights.size() == 2);
    CHECK(!scene.camera);
}

}   // namespace

TEST_CASE("one mesh is the same in every format") {
    const SceneFolder folder;
    const Octahedron o;
    folder.write("mesh data.bin", o.bin());
    const std::vector<std::pair<std::string, std::string>> files{
        {"a.obj", o.obj()},
        {"a.ply", o.ply_ascii()},
        {"little.ply", o.ply_binary(false)},
        {"big.ply", o.ply_binary(true)},
        {"a.stl", o.stl_ascii()},
        {"b.stl", o.stl_binary()},
        {"a.glb", o.glb()},
        {"outside.gltf", o.gltf("mesh%20data.bin")},
        {"inside.gltf", o.gltf("data:application/octet-stream;base64," + base64(o.bin()))},
        {"a.off", o.off()},
        {"a.3ds", o.tds()},
        {"y.dae", o.dae("Y_UP")},
        {"z.dae", o.dae("Z_UP")},
        {"x.dae", o.dae("X_UP")},
        {"a.obj.gz", gz_of(o.obj())},
        {"a.ply.gz", gz_of(o.ply_binary(false))},
        {"two.off.GZ", gz_of(o.off().substr(0, 50)) + gz_of(o.off().substr(50))},
        {"a.glb.gz", gz_of(o.glb())},
        {"a.json", o.json()}};
    for (const auto& [name, bytes] : files) {
        INFO(name);
        check_octahedron(folder.load(name, bytes));
    }
}

TEST_CASE("extensions may be in capitals and names may hold blanks") {
    const SceneFolder folder;
    check_octahedron(folder.load("An Octahedron.OBJ", Octahedron().obj()));
    check_octahedron(folder.load("A.Glb", Octahedron().glb()));
}

TEST_CASE("line ends of other systems, blank lines and comments change nothing") {
    const SceneFolder folder;
    for (const std::string& text : {Octahedron().obj(), Octahedron().ply_ascii(), Octahedron().stl_ascii()}) {
        std::string windows;
        for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
        const std::string name = text[0] == 'v' ? "a.obj" : text[0] == 'p' ? "a.ply" : "a.stl";
        INFO(name);
        check_octahedron(folder.load(name, windows));
    }
    check_octahedron(folder.load("c.obj", "\xef\xbb\xbf" + Octahedron().obj()));
    check_octahedron(folder.load("c.json", "\xef\xbb\xbf" + Octahedron().json()));
    check_octahedron(folder.load("b.obj", std::string("# nothing\n\n\t\n") + Octahedron().obj() + "\n# end"));
}

TEST_CASE("binary STL may carry something behind its triangles") {
    const SceneFolder folder;
    check_octahedron(folder.load("more.stl", "x" + Octahedron().stl_binary().substr(1) + "and more"));
}

TEST_CASE("a loaded scene passes check_scene(), and progress is reported") {
    const SceneFolder folder;
    int calls = 0;
    const Scene scene = load_scene(folder.write("a.obj", Octahedron().obj()),
                                   [&](std::string_view what, std::uint64_t done, std::uint64_t total) {
                                       CHECK(!what.empty());
                                       CHECK(done <= total);
                                       ++calls;
                                   });
    CHECK(calls > 2);
    CHECK(scene.name == "a.obj");
    CHECK_NOTHROW(check_scene(scene, "test"));
}

TEST_CASE("ply: properties may have any order and type, and other elements and lists are skipped") {
    const SceneFolder folder;
    const Scene scene = folder.load(
        "a.ply",
        "ply\nformat ascii 1.0\nobj_info x\nelement camera 1\nproperty float angle\nelement vertex 4\n"
        "property uchar red\nproperty double z\nproperty double x\nproperty double y\n"
        "element face 2\nproperty uchar flags\nproperty list uchar uint vertex_index\n"
        "element edge 1\nproperty int a\nproperty int b\nend_header\n"
        "45\n255 1 2 3\n0 1 5 3\n0 1 5 6\n9 1 2 6\n7 4 0 1 2 3\n7 2 0 1\n0 1\n");
    REQUIRE(scene.triangles.size() == 2);
    CHECK(corners_of(scene)[0][0] == glm::dvec3(2, 3, 1));
    CHECK(scene.vertices.size() == 4);
    const Corners second = corners_of(scene)[1];
    CHECK(std::find(second.begin(), second.end(), glm::dvec3(2, 6, 1)) != second.end());
}

TEST_CASE("normals are kept if the file has them, and facets next to them stay flat") {
    const SceneFolder folder;
    const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    CHECK(folder.load("flat.obj", v + "f 1 2 3\n").normals.empty());
    const Scene mixed = folder.load("mixed.obj", v + "vn 0 0 2\nvn 0.6 0 0.8\nf 1//1 2//2 3//1\nf 1 4 2\n");
    REQUIRE(mixed.normals.size() == mixed.vertices.size());
    const auto normal = [&](std::size_t t, std::size_t k) {
        return mixed.normals[mixed.triangles[t].vertex[k]];
    };
    CHECK(normal(0, 0) == glm::dvec3(0, 0, 1));
    CHECK(glm::length(normal(0, 1) - glm::dvec3(0.6, 0, 0.8)) < 1e-6);
    for (std::size_t k = 0; k < 3; ++k) CHECK(normal(1, k) == glm::dvec3(0, 1, 0));
    const Scene ply = folder.load(
        "n.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement face 1\nproperty list uchar int "
        "vertex_indices\n"
        "end_header\n0 0 0 0 0 -1\n1 0 0 0 0 -1\n0 1 0 0 0 -1\n3 0 1 2\n");
    REQUIRE(ply.normals.size() == 3);
    CHECK(ply.normals[1] == glm::dvec3(0, 0, -1));
}

TEST_CASE("a scene without lights gets a key light and a fill light at its scale") {
    const SceneFolder folder;
    const Scene small = folder.load("a.obj", Octahedron().obj());
    const Scene large =
        folder.load("a.json", R"({"meshes":{"a":{"file":"a.obj"}},"objects":[{"mesh":"a","scale":1000}]})");
    REQUIRE(small.lights.size() == 2);
    CHECK(glm::length(small.lights[0].colour) > 2 * glm::length(small.lights[1].colour));
    for (std::size_t i = 0; i < 2; ++i)
        CHECK(glm::length(large.lights[i].position - 1000.0 * small.lights[i].position) < 1e-6 * 1000);
    const Camera camera = fit_camera(small, 4.0 / 3.0);
    const glm::dvec3 right = glm::cross(camera.at - camera.eye, camera.up);
    CHECK(glm::dot(small.lights[0].position - camera.eye, right) > 0);
    CHECK(glm::dot(small.lights[0].position - camera.eye, camera.up) > 0);
    CHECK(glm::dot(small.lights[1].position - camera.eye, right) < 0);
}

TEST_CASE("built-in scenes load by name and size") {
    CHECK(load_scene("icosphere:1").triangles.size() == load_scene("icosphere:1").triangles.size());
    CHECK(!load_scene("gears:1").lights.empty());
    CHECK(complaint("geers").find("gears") != std::string::npos);
}
