// glTF: transforms of nodes, instances, strips, materials, cameras and lights.
#include <catch2/catch.hpp>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include "tests/support/scenes/scene_files.hpp"

using namespace rayclock;
using namespace rayclock::test;
using Json = nlohmann::json;

namespace {

Json document() { return Json::parse(Octahedron().gltf("")); }

Scene load(const Json& json) {
    const SceneFolder folder;
    return folder.load("a.glb", glb_of(json.dump(), Octahedron().bin()));
}

double volume(const Scene& scene) {
    double sum = 0;
    for (const Corners& t : corners_of(scene)) sum += glm::dot(t[0], glm::cross(t[1], t[2])) / 6;
    return sum;
}

}   // namespace

TEST_CASE("glTF: copies are placed by the product of their nodes") {
    Json json = document();
    json["nodes"] = {{{"children", {1, 2}}, {"translation", {10, 0, 0}}},
                     {{"mesh", 0}, {"scale", {2, 2, 2}}},
                     {{"mesh", 0}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}}};
    const Scene scene = load(json);
    REQUIRE(scene.triangles.size() == 16);
    const auto moved = corners_of(scene);
    const auto plain = Octahedron().corners();
    for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 p = plain[i][k];
            CHECK(glm::length(moved[i][k] - (2.0 * p + glm::dvec3(10, 0, 0))) < 1e-5);
            CHECK(glm::length(moved[i + 8][k] - glm::dvec3(10 - p.y, p.x, p.z)) < 1e-5);
        }
    CHECK(volume(scene) == Approx(9 * volume(load(document()))));
}

TEST_CASE("glTF: a mirrored node keeps the outside outside, also as a matrix") {
    const double inside = volume(load(document()));
    CHECK(inside > 0);
    Json json = document();
    json["nodes"][0]["scale"] = {-1, 1, 1};
    CHECK(volume(load(json)) == Approx(inside));
    json = document();
    json["nodes"][0]["matrix"] = {0, 1, 0, 0, 1, 0, 0, 0,
                                  0, 0, 1, 0, 5, 6, 7, 1};   // swaps x and y; columns first
    const Scene scene = load(json);
    CHECK(volume(scene) == Approx(inside));
    const Bounds box = bounds(scene);
    CHECK(box.hi == glm::dvec3(7.5, 9, 11));
}

TEST_CASE("glTF: strips, fans and faces without indices are triangles, and lines are left out") {
    Json json = document();
    auto& primitive = json["meshes"][0]["primitives"][0];
    primitive["mode"] = 5;
    CHECK(load(json).triangles.size() < 22);   // some join equal corners
    json["accessors"][1]["count"] = 4;         // 0 2 4 2: the second is a line
    CHECK(load(json).triangles.size() == 1);
    json = document();
    json["accessors"][1]["count"] = 4;
    json["meshes"][0]["primitives"][0]["mode"] = 6;   // 0 2 4 2: there and back
    CHECK(load(json).triangles.size() == 2);
    CHECK(volume(load(json)) == Approx(0).margin(1e-9));
    json = document();
    json["meshes"][0]["primitives"][0].erase("indices");
    CHECK(corners_of(load(json))[1][0] == Octahedron().vertices[3]);
    json["meshes"][0]["primitives"].push_back({{"mode", 1}, {"attributes", {{"POSITION", 0}}}});
    CHECK(load(json).triangles.size() == 2);
}

TEST_CASE("glTF: strides, offsets and scaled integers are read") {
    Json json = document();
    json["bufferViews"][0]["byteStride"] = 24;
    json["accessors"][0]["count"] = 3;
    json["meshes"][0]["primitives"][0].erase("indices");
    const auto v = Octahedron().vertices;
    CHECK(corners_of(load(json))[0] == Corners{v[0], v[2], v[4]});
    json = document();
    json["extensionsRequired"] = {"KHR_mesh_quantization"};
    json["meshes"][0]["primitives"][0].erase("indices");
    json["accessors"][0] = {
        {"bufferView", 1}, {"componentType", 5123}, {"count", 3}, {"normalized", true}, {"type", "VEC3"}};
    CHECK(corners_of(load(json))[0][0].z == Approx(4.0 / 65535));
}

TEST_CASE("glTF: base colour, metal and glass are read") {
    Json json = document();
    json["materials"] = {
        {{"name", "red"},
         {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 0.125, 0.5}}, {"metallicFactor", 0}}}},
        {{"pbrMetallicRoughness", {{"metallicFactor", 1}, {"roughnessFactor", 0}}}},
        {{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.25}}}}},
        {{"extensions",
          {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
           {"KHR_materials_ior", {{"ior", 1.25}}}}}}};
    const auto material = [&](int number) {
        json["meshes"][0]["primitives"][0]["material"] = number;
        const Scene scene = load(json);
        REQUIRE(scene.materials.size() == 1);
        return scene.materials[0];
    };
    CHECK(material(0).name == "red");
    CHECK(material(0).colour == glm::dvec3(0.5, 0.25, 0.125));
    CHECK(material(0).transmit == 0);
    CHECK(material(0).mirror == 0);
    CHECK(material(1).mirror == 1);
    CHECK(material(1).diffuse == 0);
    CHECK(material(2).transmit == 0.75);
    CHECK(material(3).transmit == 1);
    CHECK(material(3).index == 1.25);
}

TEST_CASE("glTF: a camera without roll has the vertical as its up direction, another its own axis") {
    const auto camera_with = [](const Json& rotation) {
        Json json = document();
        json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
        json["nodes"] = {{{"mesh", 0}}, {{"camera", 0}, {"rotation", rotation}, {"scale", {2, 2, 2}}}};
        json["scenes"][0]["nodes"] = {0, 1};
        return load(json).camera.value();
    };
    // A quarter turn about the vertical, then 30 degrees down: q = y(90) x(-30).
    const double h = std::sqrt(0.5), c = std::cos(glm::radians(15.0)), s = std::sin(glm::radians(15.0));
    const Camera down = camera_with({-h * s, h * c, h * s, h * c});
    CHECK(down.up == glm::dvec3(0, 1, 0));
    const glm::dvec3 sight = glm::normalize(down.at - down.eye);
    CHECK(sight.x == Approx(-std::cos(glm::radians(30.0))));
    CHECK(sight.y == Approx(-0.5));
    CHECK(sight.z == Approx(0).margin(1e-6));
    // Rolled by 30 degrees about the direction of sight.
    const glm::dvec3 rolled = glm::normalize(camera_with({0, 0, s, c}).up);
    CHECK(rolled.x == Approx(-0.5));
    CHECK(rolled.y == Approx(std::cos(glm::radians(30.0))));
    // Straight down, and on its head.
    CHECK(glm::normalize(camera_with({-h, 0, 0, h}).up).z == Approx(-1));
    CHECK(glm::normalize(camera_with({0, 0, 1, 0}).up).y == Approx(-1));
}

TEST_CASE("glTF: cameras and lights are placed by their nodes") {
    Json json = document();
    json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"aspectRatio", 2}}}}};
    json["extensionsUsed"] = {"KHR_lights_punctual"};
    json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "point"}, {"color", {1, 0.5, 0.25}}, {"intensity", 100}},
        {{"type", "directional"}, {"intensity", 1e-3}}};
    json["nodes"] = {{{"mesh", 0}},
                     {{"camera", 0}, {"translation", {0, 0, 20}}},
                     {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"translation", {1, 10, 0}}},
                     {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"translation", {1, 20, 0}}},
                     {{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}},
                     {{"camera", 0}, {"translation", {9, 9, 9}}}};
    json["scenes"][0]["nodes"] = {0, 1, 5, 2, 3, 4};
    const Scene scene = load(json);
    REQUIRE(scene.camera);
    CHECK(scene.camera->eye == glm::dvec3(0, 0, 20));
    CHECK(glm::normalize(scene.camera->at - scene.camera->eye) == glm::dvec3(0, 0, -1));
    CHECK(scene.camera->fov_degrees == Approx(0.5 * 57.29577951));
    REQUIRE(scene.lights.size() == 3);
    CHECK(scene.lights[0].position == glm::dvec3(1, 10, 0));
    CHECK(scene.lights[0].colour.x == Approx(1 / std::sqrt(3.0)));
    CHECK(scene.lights[0].colour.y == Approx(0.5 / std::sqrt(3.0)));
    CHECK(scene.lights[1].position == glm::dvec3(1, 20, 0));
    CHECK(scene.lights[1].colour.x < scene.lights[0].colour.x);
    CHECK(scene.lights[2].position.z > 50);   // shines along -z, from far away
}
