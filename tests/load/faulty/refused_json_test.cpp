// Faults in a JSON scene: the message names the path of the value and the value.
#include <catch2/catch.hpp>

#include <ctime>

#include <unistd.h>

#include "tests/support/scenes/scene_files.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct Bad {
    std::string text;
    std::vector<std::string> words;
};

/// Returns a scene with these parts; the rest is valid.
std::string scene(const std::string& object, const std::string& more = "",
                  const std::string& mesh = R"("builtin":"icosphere:1")") {
    return std::string("{") + more + R"("meshes":{"ball":{)" + mesh +
           R"(}},"objects":[{"mesh":"ball"},{"mesh":"ball")" + object + "}]}";
}

std::string inline_mesh(const std::string& vertices, const std::string& triangles) {
    return scene("", "", std::string("\"vertices\":") + vertices + ",\"triangles\":" + triangles);
}

/// Returns a scene of one sphere or plane with further keys.
std::string ball(const std::string& keys, const std::string& more = "") {
    return std::string("{") + more + R"("spheres":[{)" + keys + "}]}";
}
std::string floor(const std::string& keys) { return std::string(R"({"planes":[{)") + keys + "}]}"; }
std::string glass(const std::string& keys) {
    return ball(R"("centre":[0,0,0],"radius":1,"material":"glass")",
                R"("materials":{"glass":{)" + keys + "}},");
}

void check_refused(const SceneFolder& folder, const std::vector<Bad>& cases) {
    for (const Bad& bad : cases) {
        const std::string sentence = complaint(folder.write("bad.json", bad.text));
        INFO(bad.text);
        INFO("sentence: " << sentence);
        CHECK(!sentence.empty());
        CHECK(sentence.find(".json: ") + sentence.find("none.obj: ") != 2 * std::string::npos);
        CHECK(sentence.find('\n') == std::string::npos);
        for (const std::string& word : bad.words) {
            INFO("wanted: " << word);
            CHECK(sentence.find(word) != std::string::npos);
        }
    }
}

}   // namespace

TEST_CASE("malformed JSON scenes are refused") {
    const SceneFolder folder;
    REQUIRE(complaint(folder.write("good.json", scene(""))).empty());
    folder.write("self.json", R"({"meshes":{"a":{"file":"self.json"}},"objects":[{"mesh":"a"}]})");
    folder.write("a.json", R"({"meshes":{"b":{"file":"./b.json"}},"objects":[{"mesh":"b"}]})");
    folder.write("b.json", R"({"meshes":{"a":{"file":"a.json"}},"objects":[{"mesh":"a"}]})");
    const std::vector<Bad> cases{
        {"\x89PNG", {"line 1, column 1"}},
        {"[1,2]", {"must be an object", "[1,2]"}},
        {"{\"meshes\":{},\n \"objects\": [1,2,}", {"line 2, column 18"}},
        {"{\"meshes\":{\"a\":{}}", {"line 1, column 19"}},
        {R"({"objects":[]})", {"'meshes'"}},
        {R"({"meshes":{}})", {"'objects'"}},
        {R"({"meshes":{},"objects":[]})", {"objects", "empty"}},
        {R"({"meshes":{},"meshes":{},"objects":[]})", {"'meshes'", "twice"}},
        {scene("", R"("light":[],)"), {"'light'", "did you mean 'lights'"}},
        {scene(R"(,"scael":2)"), {"objects[1]", "'scael'", "did you mean 'scale'"}},
        {scene(R"(,"scale":"big")"), {"objects[1].scale", "\"big\""}},
        {scene(R"(,"scale":[1,2])"), {"objects[1].scale", "[1,2]"}},
        {scene(R"(,"scale":0)"), {"objects[1].scale", "0"}},
        {scene(R"(,"scale":[1,0,1])"), {"objects[1].scale", "[1,0,1]"}},
        {scene(R"(,"scale":1e999)"), {"1e999"}},
        {scene(R"(,"scale":1e300)"), {"objects[1].scale", "1e+300"}},
        {scene(R"(,"translate":[1,2,null])"), {"objects[1].translate", "[1,2,null]"}},
        {scene(R"(,"rotate":90)"), {"objects[1].rotate", "90"}},
        {scene(R"(,"rotate":{"axis":[0,0,0],"degrees":1})"), {"objects[1].rotate.axis", "[0,0,0]"}},
        {scene(R"(,"rotate":{"axis":[0,0,1],"angle":1})"), {"objects[1].rotate", "'angle'"}},
        {scene(R"(,"rotate":{"axis":[0,0,1]})"), {"objects[1].rotate", "'degrees'"}},
        {scene(R"(,"matrix":[1,2,3])"), {"objects[1].matrix", "[1,2,3]"}},
        {scene(R"(,"matrix":[1,0,0,0,0,1,0,0,1,1,0,0,0,0,0,1])"), {"objects[1].matrix", "array of 16"}},
        {scene(R"(,"matrix":[1,1,0,0,0,0,1,0,1,1,0,0,0,0,0,1])"), {"objects[1].matrix", "array of 16"}},
        {scene(R"(,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0.5,1])"), {"objects[1].matrix[14]", "0.5"}},
        {scene(R"(,"scale":2,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])"),
         {"objects[1]", "'matrix'", "'scale'"}},
        {scene(R"(,"material":"gold")", R"("materials":{"gald":{}},)"),
         {"objects[1].material", "'gold'", "did you mean 'gald'"}},
        {scene("", R"("materials":{"gold":{"color":[1,1,1]}},)"),
         {"materials.gold", "'color'", "did you mean 'colour'"}},
        {scene("", R"("materials":{"gold":{"colour":[1,-1,1]}},)"), {"materials.gold.colour", "[1,-1,1]"}},
        {scene("", R"("materials":{"gold":{"index":0}},)"), {"materials.gold.index", "0"}},
        {scene("", R"("materials":{"gold":{"mirror":true}},)"), {"materials.gold.mirror", "true"}},
        {scene("", R"("camera":{"eye":[0,0,5],"at":[0,0,0],"fov":45},)"), {"camera", "'fov'"}},
        {scene("", R"("camera":{"eye":[0,0,5]},)"), {"camera", "'at'"}},
        {scene("", R"("camera":{"eye":[0,0,5],"at":[0,0,0],"fov_degrees":180},)"),
         {"camera.fov_degrees", "180"}},
        {scene("", R"("camera":{"eye":[0,0,5],"at":[0,0,5]},)"), {"camera"}},
        {scene("", R"("camera":{"eye":[0,5,0],"at":[0,0,0]},)"), {"up"}},
        {scene("", R"("lights":[{"position":[1,2]}],)"), {"lights[0].position", "[1,2]"}},
        {scene("", R"("background":"blue",)"), {"background", "\"blue\""}},
        {scene("", "", R"("file":"none.obj")"), {"none.obj", "no such file"}},
        {scene("", "", R"("file":"a.txt")"), {"meshes.ball.file", "\"a.txt\""}},
        {scene("", "", R"("file":7)"), {"meshes.ball.file", "7"}},
        {scene("", "", R"("file":"x.obj","builtin":"gears:1")"), {"meshes.ball", "needs one of"}},
        {scene("", "", ""), {"meshes.ball", "needs one of"}},
        {scene("", "", R"("builtin":"geers:1")"), {"meshes.ball.builtin", "gears"}},
        {scene("", "", R"("file":"self.json")"), {"self.json", "contain itself"}},
        {scene("", "", R"("file":"a.json")"), {"a.json", "contain itself"}},
        {inline_mesh("[[0,0,0],[1,0,0],[0,1,0]]", "[[0,1,3]]"), {"meshes.ball.triangles[0][2]", "3"}},
        {inline_mesh("[[0,0,0],[1,0,0],[0,1,0]]", "[[0,1,-1]]"), {"meshes.ball.triangles[0][2]", "-1"}},
        {inline_mesh("[[0,0,0],[1,0,0],[0,1,0]]", "[[0,1]]"), {"meshes.ball.triangles[0]", "[0,1]"}},
        {inline_mesh("[[0,0,0],[1,0,0],[0,1,0]]", "[]"), {"meshes.ball.triangles", "no triangles"}},
        {inline_mesh("[[0,0,0],[1,0],[0,1,0]]", "[[0,1,2]]"), {"meshes.ball.vertices[1]", "[1,0]"}},
        {inline_mesh("[]", "[[0,1,2]]"), {"meshes.ball.triangles[0][0]", "0"}}};
    check_refused(folder, cases);
}

TEST_CASE("malformed spheres, planes, materials and lights of a JSON scene are refused") {
    const SceneFolder folder;
    check_refused(
        folder,
        {
            {"{\"spheres\":[]}", {"nothing to see"}},
            {"{\"spheres\":{}}", {"spheres", "an array"}},
            {ball(R"("centre":[0,0,0])"), {"spheres[0]", "'radius'"}},
            {ball(R"("radius":1)"), {"spheres[0]", "'centre'"}},
            {ball(R"("centre":[0,0,0],"radius":0)"), {"spheres[0].radius", "above 0", "not 0"}},
            {ball(R"("centre":[0,0,0],"radius":-1)"), {"spheres[0].radius", "-1"}},
            {ball(R"("centre":[0,0,0],"radius":nan)"), {"line 1"}},
            {ball(R"("centre":[0,0,0],"radius":null)"), {"spheres[0].radius", "null"}},
            {ball(R"("centre":[0,0],"radius":1)"), {"spheres[0].centre", "[0,0]"}},
            {ball(R"("center":[0,0,0],"radius":1)"), {"spheres[0]", "'center'", "did you mean 'centre'"}},
            {ball(R"("centre":[0,0,0],"radius":1,"material":"glas")", R"("materials":{"glass":{}},)"),
             {"spheres[0].material", "did you mean 'glass'"}},
            {ball(R"("centre":[1e308,0,0],"radius":1e308)"), {"further than a double can tell"}},
            {floor(R"("point":[0,0,0],"u":[1,0,0])"), {"planes[0]", "'v'"}},
            {floor(R"("point":[0,0,0],"u":[1,0,0],"v":[-2,0,0])"), {"planes[0].v", "parallel", "[-2,0,0]"}},
            {floor(R"("point":[0,0,0],"u":[0,0,0],"v":[1,0,0])"), {"planes[0].u", "[0,0,0]"}},
            {floor(R"("point":[0,0,0],"u":[1e200,0,0],"v":[0,1,0])"), {"planes[0].u", "1e+200"}},
            {floor(R"("u":[1,0,0],"v":[0,1,0])"), {"planes[0]", "'point'"}},
            {glass(R"("transmit":0.9,"index":0)"), {"materials.glass.index", "not 0"}},
            {glass(R"("transmit":0.9,"index":-1.5)"), {"materials.glass.index", "-1.5"}},
            {glass(R"("transmit":1.1)"), {"materials.glass.transmit", "1.1"}},
            {glass(R"("mirror":-0.1)"), {"materials.glass.mirror", "-0.1"}},
            {glass(R"("ambient":2)"), {"materials.glass.ambient", "2"}},
            {glass(R"("diffuse":2)"), {"materials.glass.diffuse", "2"}},
            {glass(R"("highlight":9)"), {"materials.glass.highlight", "9"}},
            {glass(R"("shine":-1)"), {"materials.glass.shine", "-1"}},
            {glass(R"("colour":[0.5,1.2,0])"), {"materials.glass.colour", "[0.5,1.2,0"}},
            {glass(R"("other":[0.5,-0.2,0])"), {"materials.glass.other", "[0.5,-0.2,0"}},
            {glass(R"("checkered":1)"), {"materials.glass.checkered", "true or false", "1"}},
            {glass(R"("schlick":"yes")"), {"materials.glass.schlick", "yes"}},
            {scene("", R"("background":[0,0,1.5],)"), {"background", "1.5"}},
            {scene("", R"("lights":[{"position":[0,0,0],"colour":[17,0,0]}],)"),
             {"lights[0].colour", "within 0 and 16", "[17,0,0]"}},
            {scene("", R"("lights":[{"position":[0,0,0],"colour":[1,-1,0]}],)"),
             {"lights[0].colour", "[1,-1,0]"}},
            {scene("", "", R"("builtin":"balls:1","native":1)"), {"meshes.ball.native", "true or false"}},
            {scene("", "", R"("file":"x.obj","native":true)"), {"meshes.ball.native", "builtin"}},
            {scene(R"(,"scale":[1,2,1])", "", R"("builtin":"balls:1","native":true)"),
             {"objects[1]", "stretches spheres"}},
        });
}

TEST_CASE("a million lights are refused, and soon") {
    std::string lights(R"("lights":[)");
    for (int i = 0; i < 1'000'000; ++i)
        lights += i == 0 ? R"({"position":[0,0,0]})" : R"(,{"position":[0,0,0]})";
    const SceneFolder folder;
    const std::string file = folder.write("lights.json", scene("", lights + "],"));
    const std::clock_t begin = std::clock();   // processor time, because other jobs may run
    CHECK(complaint(file) == file + ": lights has 1000000 lights; the most is 64");
    CHECK(std::clock() - begin < 20 * CLOCKS_PER_SEC);   // 1 s optimised
}

TEST_CASE("a JSON scene cannot blow up by copies of copies") {
    const SceneFolder folder;
    folder.write("s0.json", R"({"meshes":{"m":{"builtin":"icosphere:3"}},"objects":[{"mesh":"m"}]})");
    for (int i = 1; i < 4; ++i) {
        std::string text =
            std::string(R"({"meshes":{"m":{"file":"s)") + std::to_string(i - 1) + R"(.json"}},"objects":[)";
        for (int k = 0; k < 1000; ++k) text += std::string(k ? "," : "") + R"({"mesh":"m"})";
        folder.write(std::string("s") + std::to_string(i) + ".json", text + "]}");
        if (i == 1) CHECK(complaint(folder.name("s1.json")).empty());
    }
    CHECK(complaint(folder.name("s3.json")).find("triangles") != std::string::npos);
}
