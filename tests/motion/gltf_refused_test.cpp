// Deforming meshes of glTF: refused files.
#include <catch2/catch.hpp>

#include "tests/support/scenes/gltf_deforming.hpp"

using namespace rayclock;
using namespace rayclock::test;

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
    check_says(weights(-0.5f, 1.5f),
               {"a.glb", "meshes[0].primitives[0].attributes.WEIGHTS_0", "weight -0.5", "vertex 3"});
    check_says(weights(NAN, 1), {"weight nan", "vertex 3"});
    check_says(says(Skinned{}, [&](Skinned& f) { attributes(f).erase("JOINTS_0"); }),
               {"attributes", "JOINTS_0", "nodes[3]", "skin"});
    check_says(says(Skinned{}, [&](Skinned& f) { attributes(f).erase("WEIGHTS_0"); }),
               {"WEIGHTS_0", "nodes[3]"});
    check_says(says(Skinned{},
                    [&](Skinned& f) {
                        std::string joints(24, '\0');
                        joints[9] = '\2';
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
               {"channels[1].target", "earlier channel"});
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
