// Motion in JSON scenes and in glTF: its meaning, and refused files.
#include <catch2/catch.hpp>

#include <cmath>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "model/scene/placed.hpp"
#include "sim/load/json/scene.hpp"
#include "sim/load/mesh/mesh_file.hpp"
#include "tests/support/scenes/animated.hpp"
#include "tests/support/scenes/scene_files.hpp"

using namespace rayclock;
using namespace rayclock::test;
using Json = nlohmann::json;

namespace {

PlacedScene placed(const Json& json) {
    const SceneFolder folder;
    const Progress silent;
    Loading loading(silent);
    return load_json_scene(folder.write("moves.json", json.dump()), loading).scene;
}

Json scene_of(const Json& objects) {
    Json json = Json::parse(Octahedron().json());
    json["objects"] = objects;
    return json;
}

Json turned(double time, double degrees) {
    return {{"time", time}, {"rotate", {{"axis", {0, 0, 1}}, {"degrees", degrees}}}};
}

glm::dvec3 at(const PlacedScene& scene, std::size_t i, const glm::dvec3& p) {
    return glm::dvec3(scene.instances[i].place * glm::dvec4(p, 1));
}

void check_refused_scene(const Json& json, const std::vector<std::string>& parts) {
    const SceneFolder folder;
    const std::string said = complaint(folder.write("moves.json", json.dump()));
    for (const std::string& part : parts) CHECK_THAT(said, Catch::Contains(part));
}

}   // namespace

TEST_CASE("keyframes move an object, its instances, the camera and a light", "[motion]") {
    Json json = scene_of(
        {{{"mesh", "o"},
          {"keyframes", {turned(0, 0), turned(2, 720)}},
          {"instances",
           {{{"translate", {1, 0, 0}}},
            {{"keyframes",
              {{{"time", 0}, {"translate", {2, 0, 0}}}, {{"time", 1}, {"translate", {4, 0, 0}}}}}}}}}});
    json["camera"] = {{"keyframes",
                       {{{"time", 0}, {"eye", {0, 0, 9}}, {"at", {0, 0, 0}}},
                        {{"time", 4}, {"eye", {8, 0, 9}}, {"at", {0, 4, 0}}}}}};
    json["lights"] = {
        {{"keyframes", {{{"time", 1}, {"position", {0, 5, 0}}}, {{"time", 2}, {"position", {0, 7, 0}}}}}}};
    PlacedScene scene = placed(json);
    REQUIRE(scene.instances.size() == 2);
    for (const double t : {0.0, 0.1, 0.5, 0.9, 1.25}) {   // 360 degrees per second: the long way round
        pose(scene, t);
        const double a = 2 * M_PI * t, far = 2 + 2 * std::min(t, 1.0);
        CHECK(glm::length(at(scene, 0, {0, 0, 0}) - glm::dvec3(std::cos(a), std::sin(a), 0)) < 1e-9);
        CHECK(glm::length(at(scene, 1, {0, 0, 0}) - far * glm::dvec3(std::cos(a), std::sin(a), 0)) < 1e-9);
        CHECK(scene.own.camera->eye == glm::dvec3(2 * t, 0, 9));
        CHECK(scene.own.camera->at == glm::dvec3(0, t, 0));
        CHECK(scene.own.lights[0].position.y == Approx(t < 1 ? 5 : 5 + 2 * (t - 1)));
    }
}

TEST_CASE("a file with motion moves where it is placed, and in what moves there", "[motion]") {
    const SceneFolder folder;
    Json inner =
        scene_of({{{"mesh", "o"},
                   {"keyframes",
                    {{{"time", 0}, {"translate", {0, 0, 0}}}, {{"time", 1}, {"translate", {1, 0, 0}}}}}}});
    folder.write("inner.json", inner.dump());
    Json outer{{"meshes", {{"in", {{"file", "inner.json"}}}}},
               {"objects",
                {{{"mesh", "in"}, {"translate", {0, 5, 0}}, {"scale", 2}},
                 {{"mesh", "in"}, {"keyframes", {turned(0, 0), turned(1, 90)}}}}}};
    const Progress silent;
    Loading loading(silent);
    PlacedScene scene = load_json_scene(folder.write("outer.json", outer.dump()), loading).scene;
    REQUIRE(scene.instances.size() == 2);
    pose(scene, 0.5);
    CHECK(glm::length(at(scene, 0, {1, 1, 1}) - glm::dvec3(3, 7, 2)) < 1e-12);
    const double c = std::sqrt(0.5);
    CHECK(glm::length(at(scene, 1, {0, 0, 0}) - 0.5 * glm::dvec3(c, c, 0)) < 1e-12);
}

TEST_CASE("bad motion is refused by a sentence that names the key and the value", "[motion]") {
    const auto object = [](const Json& keys) { return scene_of({{{"mesh", "o"}, {"keyframes", keys}}}); };
    const Json a{{"time", 0}, {"translate", {0, 0, 0}}}, b{{"time", 1}, {"translate", {1, 0, 0}}};
    Json late = b, early = a, negative = a;
    late["time"] = 0, negative["time"] = -1;
    check_refused_scene(object({a, late}), {"objects[0].keyframes[1].time", "is 0", "order", "at 0"});
    check_refused_scene(object({b, a}), {"keyframes[1].time", "is 0", "at 1"});
    check_refused_scene(object(Json::array({a})),
                        {"objects[0].keyframes", "1 key", "two or more", "length is 0"});
    check_refused_scene(object(Json::array()), {"0 keys"});
    check_refused_scene(object({negative, b}), {"keyframes[0].time", "within 0", "-1"});
    check_refused_scene(object({a, {{"time", 1}, {"scale", 2}}}),
                        {"keyframes[1]", "first key", "'translate'"});
    check_refused_scene(object({{{"time", 0}, {"scale", {1, 0, 1}}}, {{"time", 1}, {"scale", {1, 1, 1}}}}),
                        {"keyframes[0].scale", "different from 0"});
    const Json flat{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1},
        solid{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    check_refused_scene(object({{{"time", 0}, {"matrix", solid}}, {{"time", 1}, {"matrix", flat}}}),
                        {"keyframes[1].matrix", "keeps solids solid"});
    check_refused_scene(object({{{"time", 0}, {"matrix", solid}, {"scale", 1}},
                                {{"time", 1}, {"matrix", solid}, {"scale", 1}}}),
                        {"both 'matrix' and 'scale'"});
    check_refused_scene(object({turned(0, 0), turned(1, 1e9)}),
                        {"keyframes[1].rotate.degrees", "1000000000", "360000"});
    check_refused_scene(object({a, {{"time", 1}, {"translat", {1, 0, 0}}}}), {"translat", "translate"});
    check_refused_scene(scene_of({{{"mesh", "o"}, {"translate", {1, 0, 0}}, {"keyframes", {a, b}}}}),
                        {"both 'keyframes' and 'translate'"});
    Json camera = scene_of({{{"mesh", "o"}}});
    camera["camera"] = {
        {"keyframes",
         {{{"time", 0}, {"eye", {0, 0, 1}}, {"at", {0, 0, 0}}}, {{"time", 1}, {"eye", {0, 0, 0}}}}}};
    check_refused_scene(camera, {"keyframes[1]", "'at'"});
    Json balls = scene_of({{{"mesh", "b"}, {"keyframes", {a, b}}}});
    balls["meshes"]["b"] = {{"builtin", "balls:1"}, {"native", true}};
    check_refused_scene(balls, {"moves true spheres"});
}

TEST_CASE("glTF: animations move nodes, and meshes in several places are instances", "[motion]") {
    Animated file;
    const float c = std::sqrt(0.5f);
    file.json["nodes"] = {{{"children", {1, 2}}, {"scale", {2, 2, 2}}},
                          {{"mesh", 0}, {"translation", {1, 0, 0}}},
                          {{"mesh", 0}, {"children", {3}}},
                          {{"mesh", 0}, {"translation", {0, 3, 0}}}};
    file.channel(1, "translation", {0, 1, 2}, {1, 0, 0, 2, 0, 0, 9, 0, 0}, "STEP");
    file.channel(2, "rotation", {0, 2}, {0, 0, 0, 1, 0, 0, c, c});
    file.channel(2, "translation", {0, 2}, {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0, 1, 0, 0},
                 "CUBICSPLINE");
    PlacedScene scene = file.load();
    REQUIRE(scene.meshes.size() == 1);
    REQUIRE(scene.instances.size() == 3);
    CHECK(scene.own.triangles.empty());
    pose(scene, 1.5);
    CHECK(glm::length(at(scene, 0, {0, 0, 0}) - glm::dvec3(4, 0, 0)) < 1e-6);
    // Tangents of 1 per second from 0 to 2 in two seconds: a straight line.
    const double a = M_PI / 2 * 0.75;
    CHECK(glm::length(at(scene, 1, {0, 0, 0}) - glm::dvec3(3, 0, 0)) < 1e-6);
    CHECK(glm::length(at(scene, 2, {0, 0, 0}) - 2.0 * glm::dvec3(1.5 - 3 * std::sin(a), 3 * std::cos(a), 0)) <
          1e-5);
}

TEST_CASE("glTF: a single place without motion is copied as ever, and cycles of nodes are refused",
          "[motion]") {
    Animated file;
    CHECK(file.load().instances.empty());
    CHECK(file.load().own.triangles.size() == 8);
    file.json["nodes"] = {{{"children", {1}}}, {{"mesh", 0}, {"children", {0}}}};
    file.json["scenes"] = {{{"nodes", {0}}}};
    CHECK_THAT(file.says(), Catch::Contains("nodes[0]") && Catch::Contains("appears twice"));
}

TEST_CASE("glTF: bad animations are refused with the accessor and the value", "[motion]") {
    const auto says = [](const std::string& path, const std::vector<float>& times,
                         const std::vector<float>& values) {
        Animated file;
        file.channel(0, path, times, values);
        return file.says();
    };
    const std::vector<float> two{0, 0, 0, 1, 0, 0};
    CHECK(says("translation", {0, 1}, two).empty());
    CHECK_THAT(says("translation", {1, 0.5f}, two),
               Catch::Contains("0.5") && Catch::Contains("element 1") && Catch::Contains("rise"));
    CHECK_THAT(says("translation", {1, 1}, two), Catch::Contains("time 1"));
    CHECK_THAT(says("translation", {-1, 1}, two), Catch::Contains("-1"));
    CHECK_THAT(says("translation", {0, NAN}, two), Catch::Contains("nan"));
    CHECK_THAT(says("translation", {0, 1}, {0, 0, 0, NAN, 0, 0}),
               Catch::Contains("nan") && Catch::Contains("element 1"));
    CHECK_THAT(says("translation", {0, 1, 2}, two), Catch::Contains("2 values for 3 times"));
    CHECK(says("scale", {0, 1}, {1, 1, 1, 1, 0, 1}).empty());
    CHECK_THAT(says("rotation", {0, 1}, {0, 0, 0, 1, 0, 0, 0, 0}), Catch::Contains("unit quaternion"));
    Animated twice;
    twice.channel(0, "translation", {0, 1}, two);
    twice.channel(0, "translation", {0, 1}, two);
    CHECK_THAT(twice.says(), Catch::Contains("earlier channel"));
    Animated matrix;
    matrix.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    matrix.channel(0, "translation", {0, 1}, two);
    CHECK_THAT(matrix.says(), Catch::Contains("has a matrix"));
}
