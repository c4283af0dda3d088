// Objects of JSON scenes with many instances of one mesh, and graphs of instances.
#include <catch2/catch.hpp>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "model/scene/placed.hpp"
#include "sim/load/json/scene.hpp"
#include "tests/support/scenes/scene_files.hpp"

using namespace rayclock;
using namespace rayclock::test;
using Json = nlohmann::json;

namespace {

PlacedScene placed(const SceneFolder& folder, const Json& json) {
    const Progress silent;
    Loading loading(silent);
    return load_json_scene(folder.write("placed.json", json.dump()), loading).scene;
}

Json with_instances(const Json& instances) {
    Json json = Json::parse(Octahedron().json());
    json["materials"]["red"] = {{"colour", {1, 0, 0}}};
    json["materials"]["blue"] = {{"colour", {0, 0, 1}}};
    json["objects"] = {{{"mesh", "o"}, {"material", "red"}, {"instances", instances}}};
    return json;
}

const Json three = {{{"translate", {9, 0, 0}}},
                    {{"rotate", {{"axis", {1, 2, 3}}, {"degrees", 40}}}, {"material", "blue"}},
                    {{"scale", {-1, 2, 0.5}}}};

void check_same(const Scene& a, const Scene& b) {
    REQUIRE(a.triangles.size() == b.triangles.size());
    const std::vector<Corners> of_a = corners_of(a), of_b = corners_of(b);
    for (std::size_t i = 0; i < of_a.size(); ++i) {
        INFO("triangle " << i);
        for (std::size_t k = 0; k < 3; ++k) CHECK(glm::length(of_a[i][k] - of_b[i][k]) < 1e-12);
        CHECK(a.materials[a.triangles[i].material].name == b.materials[b.triangles[i].material].name);
    }
}

}   // namespace

TEST_CASE("json: instances share their mesh, and are the same as copies of it") {
    const SceneFolder folder;
    const PlacedScene scene = placed(folder, with_instances(three));
    REQUIRE(scene.meshes.size() == 1);
    CHECK(scene.meshes[0].triangles.size() == 8);
    CHECK(scene.own.triangles.empty());
    REQUIRE(scene.instances.size() == 3);
    CHECK(scene.instances[1].name == "objects[0].instances[1]");
    CHECK(primitive_count(scene) == 24);

    Json copies = with_instances(three);
    copies["objects"] = Json::array();
    for (Json copy : three) {
        copy["mesh"] = "o";
        if (!copy.contains("material")) copy["material"] = "red";
        copies["objects"].push_back(copy);
    }
    check_same(folder.load("a.json", with_instances(three).dump()), folder.load("b.json", copies.dump()));
}

TEST_CASE("json: an object's own place is outside its instances'") {
    const SceneFolder folder;
    Json json = with_instances({{{"translate", {1, 0, 0}}}});
    json["objects"][0]["rotate"] = {{"axis", {0, 0, 1}}, {"degrees", 90}};
    const glm::dvec3 p = Octahedron().vertices[0];
    const glm::dvec3 q = corners_of(folder.load("a.json", json.dump()))[0][0];
    CHECK(glm::length(q - glm::dvec3(-p.y, p.x + 1, p.z)) < 1e-12);
}

TEST_CASE("json: a graph of instances becomes one level") {
    const SceneFolder folder;
    folder.write("inner.json", with_instances(three).dump());
    const Json outer = {
        {"materials", {{"green", {{"colour", {0, 1, 0}}}}}},
        {"meshes", {{"i", {{"file", "inner.json"}}}, {"b", {{"builtin", "icosphere:1"}}}}},
        {"objects",
         {{{"mesh", "b"}},
          {{"mesh", "i"}, {"scale", 2}},
          {{"mesh", "i"}, {"instances", {{{"translate", {0, 7, 0}}, {"material", "green"}}}}}}}};
    const PlacedScene scene = placed(folder, outer);
    CHECK(scene.meshes.size() == 1);
    CHECK(scene.instances.size() == 6);
    CHECK(scene.own.triangles.size() == 80);
    const Scene flat = flattened(scene), inner = folder.load("a.json", with_instances(three).dump());
    REQUIRE(flat.triangles.size() == 80 + 2 * 24);
    const std::vector<Corners> outside = corners_of(flat), inside = corners_of(inner);
    for (std::size_t i = 0; i < 24; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(glm::length(outside[80 + i][k] - 2.0 * inside[i][k]) < 1e-12);
            CHECK(glm::length(outside[104 + i][k] - inside[i][k] - glm::dvec3(0, 7, 0)) < 1e-12);
        }
    CHECK(flat.materials[flat.triangles[80].material].name == "red");
    CHECK(flat.materials[flat.triangles[88].material].name == "blue");
    CHECK(flat.materials[flat.triangles[112].material].name == "green");
}

TEST_CASE("json: a smooth mesh keeps its normals next to flat ones, with instances") {
    const SceneFolder folder;
    folder.write("n.obj", "v 0 0 0\nv 1 0 -1\nv 0 1 0\nvn 1 0 1\nf 1//1 2//1 3//1\n");
    Json json = with_instances(three);
    json["meshes"]["n"] = {{"file", "n.obj"}};
    json["objects"].push_back({{"mesh", "n"}, {"instances", {{{"scale", {2, 1, 1}}}}}});
    const Scene scene = folder.load("a.json", json.dump());
    REQUIRE(scene.triangles.size() == 25);
    REQUIRE(scene.normals.size() == scene.vertices.size());
    CHECK(glm::length(scene.normals[scene.triangles[24].vertex[0]] - glm::normalize(glm::dvec3(0.5, 0, 1))) <
          1e-6);
}

TEST_CASE("json: true spheres of a mesh with instances are copied") {
    const SceneFolder folder;
    const Json json = {{"meshes", {{"f", {{"builtin", "balls:1"}, {"native", true}}}}},
                       {"objects", {{{"mesh", "f"}, {"instances", {{{"scale", 2}}, {{"scale", 3}}}}}}}};
    const Scene scene = folder.load("a.json", json.dump());
    CHECK(scene.spheres.size() == 20);
    CHECK(scene.triangles.size() == 4);
}

TEST_CASE("json: a million instances load") {
    Json json = {
        {"meshes", {{"t", {{"vertices", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {"triangles", {{0, 1, 2}}}}}}},
        {"objects", {{{"mesh", "t"}, {"instances", Json::array()}}}}};
    Json& instances = json["objects"][0]["instances"];
    for (int i = 0; i < 1'000'000; ++i) instances.push_back({{"translate", {i % 1000, i / 1000, 0}}});
    const SceneFolder folder;
    const Scene scene = folder.load("a.json", json.dump());
    REQUIRE(scene.triangles.size() == 1'000'000);
    CHECK(scene.vertices[scene.triangles.back().vertex[0]] == glm::dvec3(999, 999, 0));
}

TEST_CASE("malformed instances of a JSON scene are refused with their place") {
    const SceneFolder folder;
    const auto sentence = [&](const Json& json) { return complaint(folder.write("bad.json", json.dump())); };
    const auto says = [&](const Json& instance, const std::string& words) {
        const std::string told = sentence(with_instances({{{"scale", 1}}, instance}));
        INFO("sentence: " << told);
        CHECK(told.find("bad.json: objects[0].instances[1]") != std::string::npos);
        CHECK(told.find(words) != std::string::npos);
    };
    CHECK(sentence(with_instances(three)).empty());
    CHECK(sentence(with_instances(Json::array())).find("objects[0].instances is empty") != std::string::npos);
    CHECK(sentence(with_instances(7)).find("objects[0].instances must be an array") != std::string::npos);
    says({{"scale", 0}}, ".scale must be different from 0");
    says({{"scale", 1e200}}, ".scale must be different from 0 (and within 1e-100 to 1e100)");
    says({{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1}}},
         ".matrix must be a matrix that keeps solids solid");
    says({{"matrix", {1, 0, 0}}}, ".matrix must be 16 numbers");
    says({{"rotate", {{"axis", {0, 0, 0}}, {"degrees", 1}}}}, ".rotate.axis must be a direction");
    says({{"translate", {1, nullptr, 2}}}, ".translate");
    says({{"material", "rde"}}, ".material names no material of this file: 'rde'; did you mean 'red'?");
    says({{"scael", 1}}, "scael");
    says(5, "object");
    Json nested = with_instances({{{"scale", 1}}, {{"scale", 1e-60}}});
    nested["objects"][0]["scale"] = 1e-60;
    CHECK(sentence(nested).find("objects[0].instances[1] flattens its mesh") != std::string::npos);

    std::string infinite = with_instances({{{"translate", {1, 2, 3}}}}).dump();
    infinite.replace(infinite.find("[1,2,3]"), 7, "[1,1e999,3]");
    CHECK(!complaint(folder.write("infinite.json", infinite)).empty());
    std::string far = with_instances({{{"translate", {1e300, 0, 0}}, {"scale", 1}},
                                      {{"matrix", {1, 0, 0, -1.7e308, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}},
                                      {{"translate", {1.7e308, 0, 0}}}})
                          .dump();
    CHECK(complaint(folder.write("far.json", far)).find("further than a double can tell") !=
          std::string::npos);

    const std::string own =
        R"({"meshes":{"m":{"file":"own.json"}},"objects":[{"mesh":"m","instances":[{}]}]})";
    CHECK(complaint(folder.write("own.json", own)).find("contain itself") != std::string::npos);
    // Five thousand balls of 20,480 triangles are not expanded, so no lights can be fitted to them.
    std::string many = R"({"meshes":{"b":{"builtin":"icosphere:5"}},"objects":[{"mesh":"b","instances":[{})";
    for (int i = 1; i < 5000; ++i) many += ",{}";
    CHECK(complaint(folder.write("many.json", many + "]}]}"))
              .find("many.json: 102400000 placed triangles are too many to find lights for them") !=
          std::string::npos);
}
