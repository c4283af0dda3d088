// JSON scenes of this program: copies, transforms, materials, nested files.
#include <catch2/catch.hpp>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test::json_test {

using namespace rayclock;
using namespace rayclock::test;
using Json = nlohmann::json;

namespace {

Json document() { return Json::parse(Octahedron().json()); }

Scene load(const Json& json) {
    const SceneFolder folder;
    return folder.load("a.json", json.dump());
}

double volume(const Scene& scene) {
    double sum = 0;
    for (const Corners& t : corners_of(scene)) sum += glm::dot(t[0], glm::cross(t[1], t[2])) / 6;
    return sum;
}

void check_near(const glm::dvec3& a, const glm::dvec3& b) { CHECK(glm::length(a - b) < 1e-12); }

}   // namespace

TEST_CASE("json: an object is scaled, then turned, then moved") {
    Json json = document();
    json["objects"] = {{{"mesh", "o"},
                        {"translate", {1, 2, 3}},
                        {"rotate", {{"axis", {0, 0, 5}}, {"degrees", 90}}},
                        {"scale", {2, 3, 4}}}};
    const Scene scene = load(json);
    const auto plain = Octahedron().corners();
    for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 p = plain[i][k];
            check_near(corners_of(scene)[i][k], {-3 * p.y + 1, 2 * p.x + 2, 4 * p.z + 3});
        }
}

TEST_CASE("json: a matrix is given row by row") {
    Json json = document();
    json["objects"] = {{{"mesh", "o"}, {"matrix", {1, 0, 0, 10, 0, 1, 0, 20, 0, 0, 1, 30, 0, 0, 0, 1}}}};
    check_near(corners_of(load(json))[0][0], {13, 20.25, 30});
}

TEST_CASE("json: mirror images keep the outside outside") {
    Json json = document();
    const double inside = volume(load(json));
    json["objects"][0]["scale"] = {1, -1, 1};
    CHECK(volume(load(json)) == Approx(inside));
    json["objects"][0]["scale"] = -2;
    CHECK(volume(load(json)) == Approx(8 * inside));
}

TEST_CASE("json: normals go by the inverse transpose, through mirrors as well") {
    const SceneFolder folder;
    folder.write("n.obj", "v 0 0 0\nv 1 0 -1\nv 0 1 0\nvn 1 0 1\nf 1//1 2//1 3//1\n");
    const auto normal = [&](const Json& scale) {
        const Json json = {{"meshes", {{"n", {{"file", "n.obj"}}}}},
                           {"objects", {{{"mesh", "n"}, {"scale", scale}}}}};
        const Scene scene = folder.load("n.json", json.dump());
        REQUIRE(scene.normals.size() == 3);
        const Corners t = corners_of(scene)[0];
        const glm::dvec3 facet = glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
        CHECK(glm::length(facet - scene.normals[0]) < 1e-6);
        return scene.normals[0];
    };
    CHECK(glm::length(normal({2, 1, 1}) - glm::normalize(glm::dvec3(0.5, 0, 1))) < 1e-6);
    CHECK(glm::length(normal({-1, 1, 1}) - glm::normalize(glm::dvec3(-1, 0, 1))) < 1e-6);
    CHECK(glm::length(normal(-1) - glm::normalize(glm::dvec3(-1, 0, -1))) < 1e-6);
    CHECK(glm::length(normal(1e-60) - glm::normalize(glm::dvec3(1, 0, 1))) < 1e-6);
}

TEST_CASE("json: a flat mesh has its facets' normals next to a smooth one") {
    const SceneFolder folder;
    folder.write("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0.6 0.8\nf 1//1 2//1 3//1\n");
    Json json = document();
    json["meshes"]["n"]["file"] = "n.obj";
    json["objects"].push_back({{"mesh", "n"}});
    const Scene scene = folder.load("a.json", json.dump());
    REQUIRE(scene.triangles.size() == 9);
    REQUIRE(scene.normals.size() == scene.vertices.size());
    for (std::size_t i = 0; i < 8; ++i) {
        const Corners t = corners_of(scene)[i];
        for (const std::uint32_t v : scene.triangles[i].vertex)
            check_near(scene.normals[v], glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0])));
    }
    CHECK(glm::length(scene.normals[scene.triangles[8].vertex[0]] - glm::dvec3(0, 0.6, 0.8)) < 1e-6);
}

TEST_CASE("json: camera, background, lights and materials arrive") {
    Json json = document();
    json["camera"] = {{"eye", {1, 2, 3}}, {"at", {0, 0, 1}}, {"up", {0, 0, 1}}, {"fov_degrees", 30}};
    json["background"] = {0.1, 0.2, 0.3};
    json["lights"] = {{{"position", {5, 6, 7}}, {"colour", {0.5, 0.4, 0.3}}}};
    json["materials"]["gold"] = {{"colour", {1, 0.8, 0.2}}, {"ambient", 0.2}, {"diffuse", 0.3},
                                 {"highlight", 0.4},        {"shine", 50},    {"mirror", 0.5},
                                 {"transmit", 0.1},         {"index", 1.5}};
    json["objects"].push_back({{"mesh", "o"}, {"material", "gold"}});
    const Scene scene = load(json);
    REQUIRE(scene.camera);
    CHECK(scene.camera->eye == glm::dvec3(1, 2, 3));
    CHECK(scene.camera->at == glm::dvec3(0, 0, 1));
    CHECK(scene.camera->up == glm::dvec3(0, 0, 1));
    CHECK(scene.camera->fov_degrees == 30);
    CHECK(scene.background == glm::dvec3(0.1, 0.2, 0.3));
    REQUIRE(scene.lights.size() == 1);
    CHECK(scene.lights[0].position == glm::dvec3(5, 6, 7));
    CHECK(scene.lights[0].colour == glm::dvec3(0.5, 0.4, 0.3));
    REQUIRE(scene.triangles.size() == 16);
    CHECK(scene.materials[scene.triangles[0].material].name == "default");
    const Material gold = scene.materials[scene.triangles[8].material];
    CHECK(gold.name == "gold");
    CHECK(gold.colour == glm::dvec3(1, 0.8, 0.2));
    CHECK(gold.ambient == 0.2);
    CHECK(gold.diffuse == 0.3);
    CHECK(gold.highlight == 0.4);
    CHECK(gold.shine == 50);
    CHECK(gold.mirror == 0.5);
    CHECK(gold.transmit == 0.1);
    CHECK(gold.index == 1.5);
}

TEST_CASE("json: meshes from files, scenes and built-ins keep their materials") {
    const SceneFolder folder;
    folder.write("m.mtl", "newmtl red\nKd 1 0 0\n");
    folder.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    std::filesystem::create_directories(folder.name("sub"));
    folder.write(
        "sub/part.json",
        R"({"meshes":{"m":{"file":"../m.obj"}},"objects":[{"mesh":"m"},{"mesh":"m","translate":[0,0,1]}]})");
    const Scene scene = folder.load(
        "a.json",
        R"({"meshes":{"p":{"file":"sub/part.json"},"b":{"builtin":"icosphere:1"},"m":{"file":"m.obj"}},
        "objects":[{"mesh":"p"},{"mesh":"p","translate":[9,0,0]},{"mesh":"b"},{"mesh":"m"}]})");
    const std::size_t ball = load_scene("icosphere:1").triangles.size();
    REQUIRE(scene.triangles.size() == 4 + ball + 1);
    CHECK(scene.materials[scene.triangles[3].material].colour == glm::dvec3(1, 0, 0));
    CHECK(scene.materials[scene.triangles[4].material].name == load_scene("icosphere:1").materials[0].name);
    CHECK(scene.materials[scene.triangles.back().material].name == "red");
}

TEST_CASE("json: spheres and planes arrive, with or without meshes") {
    Json json = {
        {"spheres",
         {{{"centre", {1, 2, 3}}, {"radius", 0.5}, {"material", "red"}},
          {{"centre", {0, 0, 0}}, {"radius", 1e30}}}},
        {"planes", {{{"point", {0, -1, 0}}, {"u", {2, 0, 0}}, {"v", {0, 0, -2}}, {"material", "board"}}}},
        {"materials",
         {{"red", {{"colour", {1, 0, 0}}, {"schlick", true}}},
          {"board", {{"checkered", true}, {"other", {0.1, 0.2, 0.3}}}}}}};
    const Scene scene = load(json);
    REQUIRE(scene.spheres.size() == 2);
    CHECK(scene.triangles.empty());
    CHECK(scene.spheres[0].centre == glm::dvec3(1, 2, 3));
    CHECK(scene.spheres[0].radius == 0.5);
    CHECK(scene.materials[scene.spheres[0].material].name == "red");
    CHECK(scene.materials[scene.spheres[0].material].schlick);
    CHECK(scene.materials[scene.spheres[1].material].name == "default");
    REQUIRE(scene.planes.size() == 1);
    CHECK(scene.planes[0].point == glm::dvec3(0, -1, 0));
    CHECK(scene.planes[0].v == glm::dvec3(0, 0, -2));
    const Material board = scene.materials[scene.planes[0].material];
    CHECK(board.checkered);
    CHECK_FALSE(board.schlick);
    CHECK(board.other == glm::dvec3(0.1, 0.2, 0.3));
    json.update(document());
    CHECK(load(json).triangles.size() == 8);
    CHECK(load(json).spheres.size() == 2);
}

TEST_CASE("json: a mesh may bring spheres and planes, which move with it") {
    Json json = {
        {"meshes", {{"s", {{"builtin", "spheres"}}}, {"b", {{"builtin", "balls:1"}, {"native", true}}}}},
        {"objects",
         {{{"mesh", "s"},
           {"translate", {1, 2, 3}},
           {"rotate", {{"axis", {0, 0, 1}}, {"degrees", 90}}},
           {"scale", -2}},
          {{"mesh", "b"}}}}};
    const Scene scene = load(json), spheres = load_scene("spheres");
    REQUIRE(scene.spheres.size() == spheres.spheres.size() + 10);
    for (std::size_t i = 0; i < spheres.spheres.size(); ++i) {
        const glm::dvec3 c = spheres.spheres[i].centre;
        check_near(scene.spheres[i].centre, {2 * c.y + 1, -2 * c.x + 2, -2 * c.z + 3});
        CHECK(scene.spheres[i].radius == Approx(2 * spheres.spheres[i].radius));
        CHECK(scene.materials[scene.spheres[i].material].name ==
              spheres.materials[spheres.spheres[i].material].name);
    }
    REQUIRE(scene.planes.size() == 1);
    check_near(scene.planes[0].point, {1, 2, 3});
    check_near(scene.planes[0].u, {0, -2, 0});
    check_near(scene.planes[0].v, {0, 0, 2});
    CHECK(scene.materials[scene.spheres.back().material].name == "balls");
}

TEST_CASE("an empty list of lights means darkness; no list means the usual two") {
    Json json = document();
    CHECK(load(json).lights.size() == 2);
    json["lights"] = Json::array();
    CHECK(load(json).lights.empty());
    CHECK(load_scene("square").lights.empty());
}

TEST_CASE("the form of a built-in scene is the caller's choice") {
    CHECK(load_scene("balls:1").spheres.empty());
    CHECK(load_scene("balls:1", {}, Primitives::native).spheres.size() == 10);
}

TEST_CASE("the example scenes load") {
    for (const auto& entry : std::filesystem::directory_iterator("scenes")) {
        const std::string kind = entry.path().extension().string();
        if (kind != ".json" && kind != ".obj") continue;
        INFO(entry.path());
        CHECK_NOTHROW(load_scene(entry.path().string()));
        CHECK(entry.file_size() < 10'000);
    }
}

}   // namespace rayclock::test::json_test
