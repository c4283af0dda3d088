// Hostile files: each loads or is refused with a sentence, in time and memory proportional to its size.
#include <catch2/catch.hpp>

#include <ctime>

#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "model/base/nearest.hpp"
#include "model/base/quote.hpp"
#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test::proportional_cost_test {

using namespace rayclock;
using namespace rayclock::test;
using Json = nlohmann::json;

namespace {

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

std::string nested(int depth) { return repeated("[", depth) + repeated("]", depth); }

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Loads the file or is refused; returns the sentence. A file of a few megabytes takes less than a second
/// here.
std::string quick(const std::string& file) {
    const double start = processor_seconds();
    const std::string sentence = complaint(file);
    CHECK(processor_seconds() - start < 3);   // ten times the usual, for slow machines and sanitizers
    CHECK(sentence.size() < 1000);
    for (const char c : sentence) CHECK((static_cast<unsigned char>(c) >= 0x20 && c != 0x7f));
    return sentence;
}

void check_says(const std::string& sentence, const std::vector<std::string>& words) {
    INFO("sentence: " << sentence);
    for (const std::string& word : words) {
        INFO("wanted: " << word);
        CHECK(sentence.find(word) != std::string::npos);
    }
}

const std::string v3 = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string two_triangles = R"("vertices":[[0,0,0],[1,0,0],[0,1,0]],"triangles":[[0,1,2],[0,2,1]])";

Json gltf() { return Json::parse(Octahedron().gltf("")); }
std::string glb(const Json& json) { return glb_of(json.dump(), Octahedron().bin()); }

}   // namespace

TEST_CASE("JSON nested deeper than the stack is refused") {
    const SceneFolder folder;
    for (const std::string& text :
         {nested(60'000), R"({"camera":)" + nested(60'000) + "}",
          R"({"meshes":{"a":{"vertices":)" + nested(201) + "}}}",
          repeated(R"({"a":)", 60'000) + "1" + repeated("}", 60'000), repeated("[", 60'000)})
        check_says(quick(folder.write("deep.json", text)),
                   {folder.name("deep.json"), "nested deeper than 200"});
    const std::string deep = R"({"asset":{"version":"2.0"},"extras":)" + nested(60'000) + "}";
    check_says(quick(folder.write("deep.gltf", deep)), {"deep.gltf", "nested deeper than 200"});
    check_says(quick(folder.write("deep.glb", glb_of(deep, ""))), {"deep.glb", "nested deeper than 200"});
    Json kept = gltf();
    kept["extras"] = Json::parse(nested(198));
    CHECK(complaint(folder.write("kept.glb", glb(kept))).empty());
}

TEST_CASE("a JSON number that no double holds is refused with its place") {
    const SceneFolder folder;
    check_says(quick(folder.write("a.json", "{\n \"camera\": {\"eye\": [1e999, 0, 0]}}")),
               {"a.json: line 2, column", "'1e999'", "double"});
    check_says(quick(folder.write("a.json", "{\"camera\": -1" + repeated("0", 400) + "}")),
               {"a.json: line 1", "double"});
    std::string text = gltf().dump();
    text.replace(text.find("72"), 2, "1e400");
    check_says(quick(folder.write("a.glb", glb_of(text, Octahedron().bin()))), {"a.glb: line 1", "'1e400'"});
}

TEST_CASE("a key that occurs twice in a file is refused") {
    const SceneFolder folder;
    check_says(quick(folder.write("a.json", R"({"meshes":{},"objects":[],"meshes":{}})")),
               {"'meshes'", "twice"});
    std::string text = gltf().dump();
    text.replace(text.find("\"nodes\""), 7, "\"mesh\":[],\"mesh\":[],\"nodes\"");
    check_says(quick(folder.write("a.glb", glb_of(text, Octahedron().bin()))), {"'mesh'", "twice"});
}

TEST_CASE("pipes, devices and folders are refused by every reader") {
    const SceneFolder folder;
    const Octahedron o;
    const auto pipe = [&](const std::string& name) {
        REQUIRE(::mkfifo(folder.name(name).c_str(), 0600) == 0);
    };
    for (const char* name :
         {"a.obj", "a.ply", "a.stl", "a.glb", "a.gltf", "a.json", "p.mtl", "p.bin", "p.obj"})
        pipe(name);
    for (const char* name : {"a.obj", "a.ply", "a.stl", "a.glb", "a.gltf", "a.json"})
        CHECK(quick(folder.name(name)) == folder.name(name) + ": is not an ordinary file");
    std::filesystem::create_directory(folder.name("d.mtl"));
    const std::string obj = v3 + "usemtl a\nf 1 2 3\n";
    check_says(quick(folder.write("b.obj", "\nmtllib p.mtl\n" + obj)),
               {"p.mtl: is not an ordinary file", "b.obj: line 2 asks for it"});
    check_says(quick(folder.write("b.obj", "mtllib d.mtl\n" + obj)),
               {"d.mtl: is a directory", "b.obj: line 1 asks for it"});
    check_says(quick(folder.write("b.gltf", o.gltf("p.bin"))),
               {"p.bin: is not an ordinary file", "b.gltf: buffers[0].uri asks for it"});
    const std::string scene = R"({"meshes":{"m":{"file":"p.obj"}},"objects":[{"mesh":"m"}]})";
    check_says(quick(folder.write("b.json", scene)),
               {"p.obj: is not an ordinary file", "b.json: meshes.m.file asks for it"});
}

TEST_CASE("a message about a missing file names that file and the file that refers to it") {
    const SceneFolder folder;
    check_says(quick(folder.write("a.gltf", Octahedron().gltf("none.bin"))),
               {folder.name("none.bin") + ": there is no such file",
                folder.name("a.gltf") + ": buffers[0].uri asks for it"});
    const auto scene = [](const std::string& file) {
        return R"({"meshes":{"m":{"file":")" + file + R"("}},"objects":[{"mesh":"m"}]})";
    };
    check_says(quick(folder.write("a.json", scene("none.obj"))),
               {folder.name("none.obj") + ": there is no such file", "a.json: meshes.m.file asks"});
    check_says(quick(folder.write("b.json", scene("c.json"))),
               {folder.name("c.json") + ": there is no such file", "b.json: meshes.m.file asks"});
}

TEST_CASE("a glTF file reads no buffer outside its folder, and a name holds no zero byte") {
    const SceneFolder folder;
    const Octahedron o;
    std::filesystem::create_directory(folder.name("in"));
    folder.write("out.bin", o.bin());
    folder.write("in/in.bin", o.bin());
    for (const std::string& name : {std::string("../out.bin"), folder.name("out.bin"),
                                    std::string("%2e%2E/out.bin"), std::string("x/../../out.bin")})
        check_says(quick(folder.write("in/a.gltf", o.gltf(name))),
                   {"a.gltf: buffers[0].uri names", "outside the folder"});
    CHECK(complaint(folder.write("in/a.gltf", o.gltf("x/../in.bin"))).find("x/../in.bin") !=
          std::string::npos);   // there is no folder x
    CHECK(complaint(folder.write("in/a.gltf", o.gltf("./in.bin"))).empty());
    check_says(quick(folder.write("in/a.gltf", o.gltf("in.bin%00.txt"))), {"\\x00", "zero byte"});
}

TEST_CASE("what is odd in names and values is escaped and cut") {
    const SceneFolder folder;
    const std::string odd = "\\u001b]0;x\\u0007\\u0000\\u202e", longer = repeated("long ", 200'000);
    for (const std::string& name : {odd, longer}) {
        for (const std::string& text :
             {R"({")" + name + R"(":1})", R"({"materials":{")" + name + R"(":{"shine":-1}}})",
              R"({"meshes":{"a":{"file":")" + name + R"("}}})",
              R"({"meshes":{")" + name + R"(":{"file":"x.obj"}},"objects":[]})",
              R"({"camera":")" + name + R"("})", R"({"meshes":{"a":{"builtin":")" + name + R"("}}})",
              R"({"meshes":{")" + name + R"(":{)" + two_triangles + R"(}},"objects":[{"mesh":"a"}]})",
              R"({"meshes":{"a":{)" + two_triangles + R"(}},"objects":[{"mesh":")" + name + R"("}]})"}) {
            INFO(text.substr(0, 80));
            CHECK(!quick(folder.write("a.json", text)).empty());
        }
    }
    CHECK(printable("a\x1b[2Jb\x7f\n\xff\xc2\x9b") == "a\\x1b[2Jb\\x7f\\x0a\\xff\\xc2\\x9b");
    CHECK(printable("Würfel \xe2\x80\xae") == "Würfel \\xe2\\x80\\xae");
    CHECK(printable(std::string(100, 'a') + std::string(100, 'b'), 30) ==
          std::string(17, 'a') + "..." + std::string(10, 'b'));
    // The limit applies to the displayed text, and no letter is cut in two.
    CHECK(printable(std::string(29, '\xff') + "b", 30) == "\\xff\\xff\\xff\\xff...\\xff\\xffb");
    CHECK(printable("\xc3\xbc" + std::string(28, '\xff') + "\xc3\xbc", 30) ==
          "\xc3\xbc\\xff\\xff\\xff...\\xff\\xff\xc3\xbc");
    for (const std::string& text :
         {std::string(500, '\x1b'), "\xff" + std::string(500, 'a'), std::string(299, 'a') + "\xff"}) {
        CHECK(printable(text).size() <= 300);
        CHECK(printable(printable(text)) == printable(text));
    }
    CHECK(shown(std::string(41, 'x')) == "'" + std::string(40, 'x') + "...'");
    // They are not compared, since that would take the square of a megabyte, and are listed as 40 letters.
    CHECK(did_you_mean(std::string(1 << 20, 'x'), std::vector<std::string>{std::string(1 << 20, 'y')}) ==
          "; there are '" + std::string(40, 'y') + "...'");
}

TEST_CASE("the time to read materials, primitives and nodes grows in proportion to their number") {
    const SceneFolder folder;
    std::string obj = v3, mtl;
    for (int i = 0; i < 80'000; ++i) (obj += "usemtl m") += std::to_string(i) + "\nf 1 2 3\n";
    for (int i = 0; i < 80'000; ++i) (mtl += "newmtl m") += std::to_string(i) + "\nKd 1 0 0\n";
    folder.write("m.mtl", mtl);
    CHECK(quick(folder.write("a.obj", "mtllib m.mtl\n" + obj)).empty());
    Json json = gltf();
    for (int i = 0; i < 80'000; ++i) json["materials"].push_back({{"name", "material " + std::to_string(i)}});
    json["accessors"].push_back(
        {{"bufferView", 1}, {"componentType", 5123}, {"count", 3}, {"type", "SCALAR"}});
    for (int i = 0; i < 20'000; ++i)
        json["meshes"][0]["primitives"].push_back(
            {{"attributes", {{"POSITION", 0}}}, {"indices", 2}, {"material", i}});
    CHECK(quick(folder.write("a.glb", glb(json))).empty());
    json = gltf();
    for (int i = 0; i < 300'000; ++i) json["nodes"].push_back(Json::object());
    CHECK(quick(folder.write("b.glb", glb(json))).empty());
    json = {{"meshes", {{"b", {{"builtin", "icosphere:1"}}}}}, {"objects", {{{"mesh", "b"}}}}};
    for (int i = 0; i < 80'000; ++i) json["materials"]["m" + std::to_string(i)] = {{"shine", 1}};
    CHECK(quick(folder.write("a.json", json.dump())).empty());
}

TEST_CASE("a megabyte of names of missing files, or of faces with few distinct corners, is read quickly") {
    const SceneFolder folder;
    std::string names = "mtllib", places, face = "f";
    for (int i = 0; i < 150'000; ++i) (names += ' ') += std::to_string(i);
    CHECK(quick(folder.write("names.obj", names + "\n" + v3 + "f 1 2 3\n")).empty());
    for (int i = 0; i < 9; ++i)
        ((places += "v ") += std::to_string(i * i % 7) += ' ') += std::to_string(i * 5 % 9) + " 0\n";
    unsigned random = 1;
    for (int i = 0; i < 10'000; ++i)
        (face += ' ') += std::to_string(1 + (random = random * 1'664'525 + 1'013'904'223) / 65'536 % 9);
    CHECK(quick(folder.write("places.obj", places + repeated(face + "\n", 49))).empty());
}

TEST_CASE("a small file cannot declare more than its size allows") {
    const SceneFolder folder;
    const std::string much = "makes more than 1024 MB";
    // Copies of copies, also of materials.
    std::string obj = v3;
    for (int i = 0; i < 1000; ++i) (obj += "usemtl m") += std::to_string(i) + "\nf 1 2 3\n";
    folder.write("n0.obj", obj);
    for (int level = 1; level <= 6; ++level) {
        Json json;
        for (int i = 0; i < 30; ++i) {
            const std::string name = "m" + std::to_string(i);
            json["meshes"][name] = {
                {"file", level == 1 ? "n0.obj" : "n" + std::to_string(level - 1) + ".json"}};
            json["objects"].push_back({{"mesh", name}});
        }
        folder.write("n" + std::to_string(level) + ".json", json.dump());
    }
    check_says(complaint(folder.name("n6.json")), {"n3.json", "objects", much});
    // One block of numbers, read through many accessors.
    Json json = gltf();
    std::string bin = Octahedron().bin();
    bin.resize(400'000, '\0');
    json["buffers"][0]["byteLength"] = bin.size();
    json["bufferViews"].push_back({{"buffer", 0}, {"byteLength", bin.size()}});
    for (int i = 0; i < 3000; ++i) {
        json["accessors"].push_back(
            {{"bufferView", 2}, {"componentType", 5121}, {"count", 133'332}, {"type", "VEC3"}});
        json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", 2 + i}}}}}}});
        json["nodes"].push_back({{"mesh", 1 + i}});
        json["scenes"][0]["nodes"].push_back(1 + i);
    }
    check_says(complaint(folder.write("a.glb", glb_of(json.dump(), bin))), {"accessors[", much});
    // One list of indices, drawn many times: nothing remains of it, but it takes time.
    json["accessors"].push_back(
        {{"bufferView", 2}, {"componentType", 5121}, {"count", 99'999}, {"type", "SCALAR"}});
    json["meshes"] = {{{"primitives", Json::array()}}};
    json["nodes"] = {{{"mesh", 0}}};
    json["scenes"][0]["nodes"] = {0};
    for (int i = 0; i < 2500; ++i)
        json["meshes"][0]["primitives"].push_back(
            {{"attributes", {{"POSITION", 0}}}, {"indices", json["accessors"].size() - 1}});
    const double start = processor_seconds();
    check_says(complaint(folder.write("b.glb", glb_of(json.dump(), std::string(bin.size(), '\0')))),
               {"b.glb", much});
    CHECK(processor_seconds() - start < 20);
    // Built-in scenes count before they are made.
    Json builtins;
    for (int i = 9; i <= 11; ++i)
        builtins["meshes"]["t" + std::to_string(i)] = {{"builtin", "tetra:" + std::to_string(i)}};
    for (int i = 0; i < 20; ++i) builtins["objects"].push_back({{"mesh", "t11"}});
    check_says(complaint(folder.write("t.json", builtins.dump())), {"t.json", "makes more than"});
}

TEST_CASE("a word of ten million letters is refused as quickly as it is read") {
    const SceneFolder folder;
    const std::string ones(10'000'000, '1'), letters(10'000'000, 'x');
    for (const std::string& word : {ones, "0." + ones, letters, "-" + ones}) {
        check_says(quick(folder.write("a.obj", "v 0 " + word + " 0\n" + v3 + "f 1 2 3\n")),
                   {"a.obj: line 1", "...'"});
        CHECK(quick(folder.write("a.obj", v3 + "v 0 " + word + " 0\nf 1 2 3\n")).empty());
        check_says(quick(folder.write("a.obj", v3 + "f 1 2 " + word + "\n")), {"a.obj: line 4", "...'"});
        check_says(quick(folder.write("a.stl",
                                      "solid x\nfacet normal 0 0 1\nouter loop\nvertex " + word + " 0 0\n")),
                   {"a.stl: line 4", "...'"});
        check_says(quick(folder.write("a.json", "{\"camera\": [" + word + "]}")), {"a.json"});
    }
    check_says(quick(folder.write("b.obj", letters)), {"b.obj: line 1", "...'"});
    CHECK(quick(folder.write("c.obj", v3 + "usemtl " + letters + "\nf 1 2 3\n")).empty());
    check_says(quick(folder.write("a.ply", "ply\nformat " + letters)), {"a.ply: line 2"});
}

TEST_CASE("what a file holds and is not drawn is said, and counted") {
    const SceneFolder folder;
    const auto notes_of = [&](const std::string& name, const std::string& bytes,
                              Textures textures = Textures::drawn) {
        std::vector<std::string> notes;
        load_scene(folder.write(name, bytes), {}, Primitives::triangles, &notes, textures);
        return notes;
    };
    using Notes = std::vector<std::string>;
    CHECK(notes_of("good.glb", Octahedron().glb()).empty());
    CHECK(notes_of("good.obj", Octahedron().obj()).empty());
    CHECK(notes_of("flat.obj", v3 + "f 1 2 3\nf 1 2 2\nf 1 1 1\n") ==
          Notes{folder.name("flat.obj") + ": 2 triangles with two corners in one place left out"});
    CHECK(notes_of("none.obj", "\nmtllib none.mtl\n" + v3 + "usemtl a\nf 1 2 3\n") ==
          Notes{folder.name("none.obj") + ": line 2: the material file " + folder.name("none.mtl") +
                " does not exist; its materials are grey"});
    folder.write(
        "m.mtl",
        "newmtl a\nKd 1.5 0 0\nnewmtl b\nNs -3\nnewmtl c\nKd 1 1 1\nmap_Kd c.png\nnewmtl d\nKd 9 9 9\n");
    const std::string three =
        "mtllib m.mtl\n" + v3 + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\n";
    const std::string out_of_range =
        folder.name("odd.obj") +
        ": 2 materials with values out of range, taken as the nearest within (the first: 'a')";
    CHECK(notes_of("odd.obj", three, Textures::averaged) ==
          Notes{out_of_range,
                folder.name("odd.obj") + ": 1 material with textures, which are not drawn ('c')"});
    CHECK(notes_of("odd.obj", three) == Notes{folder.name("odd.obj") + ": a picture is not drawn: " +
                                                  folder.name("c.png") + ": there is no such file",
                                              out_of_range});
    std::filesystem::create_directory(folder.name("in"));
    CHECK(notes_of("in/a.obj", "mtllib ../m.mtl\n" + v3 + "usemtl c\nf 1 2 3\n").at(0) ==
          folder.name("in/a.obj") +
              ": line 1: the material file '../m.mtl' lies outside the folder of the mesh");

    Json json = gltf();
    json["materials"] = {
        {{"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", 0}}}, {"metallicFactor", 1.5}}}}};
    const Json nothing{{"channels", Json::array()}, {"samplers", Json::array()}};
    json["animations"] = Json::array({nothing, nothing, nothing});
    Json& primitives = json["meshes"][0]["primitives"];
    primitives[0]["targets"] = Json::array();
    primitives[0]["material"] = 0;
    primitives[0]["attributes"]["COLOR_0"] = 0;
    primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
    const std::string file = folder.name("all.glb") + ": ";
    CHECK(notes_of("all.glb", glb(json)) ==
          Notes{file + "2 animations after the first left out",
                file + "6 vertices with a colour out of range, taken as the nearest within (the first: "
                       "'meshes[0].primitives[0].attributes.COLOR...')",
                file + "1 primitive of points or lines left out ('meshes[0].primitives[1]')",
                file + "8 faces with corners of different colours, drawn in their mean",
                file + "1 material with other textures, which are not drawn ('material 0')",
                file + "1 material with values out of range, taken as the nearest within ('material 0')"});
    // glTF 1.0 is another format.
    check_says(complaint(folder.write("one.gltf", R"({"asset":{"version":"1.0"},"buffers":{"a":{}}})")),
               {"glTF 1.0 is not supported", "2.0"});
    check_says(complaint(folder.write("one.gltf", R"({"buffers":{"a":{}},"meshes":{}})")),
               {"glTF 1.0", "not supported", "2.0"});
}

TEST_CASE("COLLADA that repeats itself is read once, or refused") {
    const auto document = [](const std::string& primitives, const std::string& sources = {},
                             const std::string& of_vertex = {}) {
        return "<COLLADA><library_geometries><geometry id=\"g\"><mesh><source id=\"s\"><float_array "
               "id=\"a\">0 0 0 1 0 "
               "0 0 1 0</float_array><technique_common><accessor source=\"#a\" count=\"3\" stride=\"3\"/>"
               "</technique_common></source>" +
               sources + "<vertices id=\"v\">" + of_vertex +
               "<input semantic=\"POSITION\" source=\"#s\"/></vertices>" + primitives +
               "</mesh></geometry></library_geometries></COLLADA>";
    };
    const std::string input = "<input semantic=\"VERTEX\" source=\"#v\"/>", face = "<p>0 1 2</p>";
    const SceneFolder folder;
    // Faces without corners, again for each list of corners.
    check_says(
        quick(folder.write("a.dae", document("<polylist>" + input + "<vcount>" + repeated("0 ", 200'000) +
                                             "</vcount>" + repeated("<p/>", 100'000) + "</polylist>"))),
        {"a.dae: line 1", "a polylist with 100000 <p>"});
    check_says(quick(folder.write("a.dae", document("<polylist>" + input + "<vcount>" +
                                                    repeated("0 ", 200'000) + "</vcount><p/></polylist>"))),
               {"no triangles"});
    // The inputs of vertices, for each input that names them again.
    CHECK(
        quick(folder.write("a.dae", document("<triangles>" + repeated(input, 12'000) + face + "</triangles>",
                                             {}, repeated("<input semantic=\"X\" source=\"#s\"/>", 12'000))))
            .empty());
    // An array, for each source that names it again: with few of its numbers, and with all.
    for (const char* count : {"3", "75000"}) {
        std::string sources =
                        "<float_array id=\"B\">" + repeated("0 0 0 1 0 0 0 1 0 ", 25'000) + "</float_array>",
                    primitives;
        for (int i = 0; i < 1800; ++i) {
            const std::string name = "q" + std::to_string(i);
            sources += "<source id=\"" + name + "\"><technique_common><accessor source=\"#B\" count=\"" +
                       count + "\" stride=\"3\"/></technique_common></source>";
            primitives += "<triangles>" + input + "<input semantic=\"NORMAL\" source=\"#" + name + "\"/>" +
                          face + "</triangles>";
        }
        CHECK(quick(folder.write("a.dae", document(primitives, sources))).empty());
    }
    // A shader, for each material that uses it again.
    std::string materials, bound;
    for (int i = 0; i < 4000; ++i) {
        const std::string name = "m" + std::to_string(i);
        materials += "<material id=\"" + name + "\"><instance_effect url=\"#e\"/></material>";
        bound +=
            "<node><instance_geometry url=\"#g\"><bind_material><technique_common><instance_material "
            "symbol=\"s\" target=\"#" +
            name + "\"/></technique_common></bind_material></instance_geometry></node>";
    }
    std::string text = document("<triangles material=\"s\">" + input + face + "</triangles>");
    text.insert(
        text.find("<library_geometries>"),
        "<library_effects><effect id=\"e\"><profile_COMMON><technique><phong>" + repeated("<x/>", 40'000) +
            "</phong></technique></profile_COMMON></effect></library_effects><library_materials>" +
            materials + "</library_materials><library_visual_scenes><visual_scene id=\"V\">" + bound +
            "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#V\"/></scene>");
    check_says(quick(folder.write("a.dae", text)), {"a.dae: line 1", "phong with more than 100 elements"});
}

}   // namespace rayclock::test::proportional_cost_test
