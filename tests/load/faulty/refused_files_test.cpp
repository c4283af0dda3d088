// Every fault in a file gives one sentence with the file, the line if there is one, and the value.
#include <catch2/catch.hpp>

#include <unistd.h>

#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test::refused_files_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct Bad {
    std::string name, bytes;
    /// Words that the sentence must contain, in addition to the file's name.
    std::vector<std::string> words;
};

void check(const std::vector<Bad>& cases) {
    for (const Bad& bad : cases) {
        const SceneFolder folder;
        const std::string file = folder.write(bad.name, bad.bytes);
        const std::string sentence = complaint(file);
        INFO(bad.name << ": " << bad.bytes.substr(0, 200));
        INFO("sentence: " << sentence);
        CHECK(sentence.starts_with(file + ": "));
        CHECK(sentence.find('\n') == std::string::npos);
        for (const std::string& word : bad.words) {
            INFO("wanted: " << word);
            CHECK(sentence.find(word) != std::string::npos);
        }
    }
}

std::string with(std::string text, const std::string& old, const std::string& fresh) {
    const std::size_t at = text.find(old);
    REQUIRE(at != std::string::npos);
    return text.replace(at, old.size(), fresh);
}

const std::string png =
    std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\2\0\0\0\1\x80\x08\2\0\0\0", 29) + std::string(200, '\x7f');
const std::string v3 = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

}   // namespace

TEST_CASE("a missing or unreadable file is refused by name") {
    const SceneFolder folder;
    CHECK(complaint(folder.name("none.obj")) == folder.name("none.obj") + ": there is no such file");
    CHECK(complaint(folder.name("none.json")) == folder.name("none.json") + ": there is no such file");
    CHECK(complaint("none.xyz").find("none.xyz: there is no such file") == 0);
    CHECK(complaint(folder.name("none")).find("no such file") != std::string::npos);
    std::filesystem::create_directories(folder.name("folder.obj"));
    CHECK(complaint(folder.name("folder.obj")) == folder.name("folder.obj") + ": is a directory, not a file");
    CHECK(complaint(folder.name("")).find("is a directory") != std::string::npos);
    CHECK(complaint(folder.write("a.words", "x"))
              .find("(.obj .ply .stl .off .3ds .dae .glb .gltf, by Assimp .fbx") != std::string::npos);
    CHECK(complaint("").find("empty") != std::string::npos);
    CHECK(complaint(folder.write("empty.obj", "")) == folder.name("empty.obj") + ": the file is empty");
    CHECK(complaint("/dev/null").find("/dev/null: is not an ordinary file") == 0);
    CHECK(complaint("icospher").find("icosphere") != std::string::npos);
    CHECK(complaint("icosphere:x").find("x") != std::string::npos);
    const std::string locked = folder.write("locked.obj", v3 + "f 1 2 3\n");
    std::filesystem::permissions(locked, std::filesystem::perms::none);
    if (geteuid() != 0) CHECK(complaint(locked) == locked + ": cannot be read (Permission denied)");
}

TEST_CASE("malformed OBJ files are refused") {
    check({{"a.obj", png, {"line 2", "this is not OBJ"}},
           {"a.obj", "# only words\n", {"no triangles"}},
           {"a.obj", v3, {"no triangles"}},
           {"a.obj", v3 + "l 1 2 3\np 1\nf 1 2\n", {"no triangles"}},
           {"a.obj", v3 + "f 1 1 2\n", {"no triangles", "points or lines"}},
           {"a.obj", v3 + "f 1 2 0\n", {"line 4", "index 0"}},
           {"a.obj", v3 + "f 1 2 4\n", {"line 4", "4", "has 3"}},
           {"a.obj", v3 + "f 1 2 3\nf 3 2 9\nf 1 2 99\nv 4 4 4\n", {"line 5", "9", "has 4"}},
           {"a.obj", v3 + "f -1 -2 -4\n", {"line 4", "-4", "3"}},
           {"a.obj", v3 + "f 1 2 -9223372036854775808\n", {"line 4", "-9223372036854775808"}},
           {"a.obj", v3 + "f 1 2 99999999999999999999\n", {"line 4", "'99999999999999999999'"}},
           {"a.obj", v3 + "f 1 2 three\n", {"line 4", "'three'"}},
           {"a.obj", v3 + "f 1 2 2.5\n", {"line 4", "'2.5'"}},
           {"a.obj", v3 + "f 1/x 2 3\n", {"line 4", "'x'"}},
           {"a.obj", v3 + "f 1//x 2//1 3//1\n", {"line 4", "'x'"}},
           {"a.obj", std::string("v 0 0 nan\n") + v3 + "f 1 2 3\n", {"line 1", "'nan'", "finite"}},
           {"a.obj", v3 + "v 0 -inf 0\nf 1 2 4\n", {"line 4", "'-inf'", "finite"}},
           {"a.obj", v3 + "v 0 1e39 0\nf 1 2 4\n", {"line 4", "'1e39'", "32-bit"}},
           {"a.obj", v3 + "v 0 1e999 0\nf 1 2 4\n", {"line 4", "'1e999'", "32-bit"}},
           {"a.obj", v3 + "v 0 1,5 0\nf 1 2 4\n", {"line 4", "'1,5'"}},
           {"a.obj", v3 + "v 0 0x1 0\nf 1 2 4\n", {"line 4", "'0x1'"}},
           {"a.obj", v3 + "v 0 1\nf 1 2 4\n", {"line 4", "has 2"}},
           {"a.obj", v3 + "\\\n\nf 1 \\\n 2 3\nf 1 2 foo\n", {"line 8", "'foo'"}},
           {"a.obj", v3 + "F 1 2 3\n", {"line 4", "'F'"}},
           {"a.obj", std::string("newmtl x\n") + v3, {"line 1", "'newmtl'"}},
           {"a.obj", v3 + "vt 0 0\nparam 1\n", {"line 5", "'param'", "did you mean 'parm'"}},
           {"a.obj", v3 + std::string("f 1 2 3\0\n", 9), {"line 4", "\\x00"}}});
    const SceneFolder folder;
    folder.write("bad.mtl", "newmtl a\nKd 1 2 blue\n");
    folder.write("nan.mtl", "newmtl a\nKd 1 0 0\nNs nan\n");
    const std::string obj = v3 + "usemtl a\nf 1 2 3\n";
    CHECK(complaint(folder.write("a.obj", std::string("mtllib bad.mtl\n") + obj)) ==
          folder.name("bad.mtl") + ": line 2: 'blue' is not a number");
    CHECK(complaint(folder.write("a.obj", std::string("mtllib nan.mtl\n") + obj)) ==
          folder.name("nan.mtl") + ": line 3: 'nan' is not a finite number");
    std::string many = "f";
    for (int i = 0; i < 20'000; ++i) many += " 1";
    CHECK(complaint(folder.write("a.obj", v3 + many + "\n")).find("line 4: a face with 20000 corners") !=
          std::string::npos);
}

TEST_CASE("malformed PLY files are refused") {
    const Octahedron o;
    const std::string text = o.ply_ascii(), little = o.ply_binary(false), big = o.ply_binary(true);
    const std::size_t body = little.find("end_header\n") + 11;
    std::string nan_vertex = little, bad_index = little, many = little;
    nan_vertex.replace(body + 12, 4, raw(std::nanf("")));
    bad_index.replace(body + 72 + 1, 4, raw(std::uint32_t{6}));
    many[body + 72] = '\xff';
    check({{"a.ply", png, {"line 1", "PNG"}},
           {"a.ply", "solid x\n", {"line 1", "'solid'"}},
           {"a.ply", "ply\nformat ascii 1.0\n", {"end_header"}},
           {"a.ply", with(text, "ascii", "asci"), {"line 2", "'asci'"}},
           {"a.ply", with(text, " 1.0", " 2.0"), {"line 2", "1.0"}},
           {"a.ply", with(text, "vertex 6", "vertex six"), {"line 4", "'six'"}},
           {"a.ply", with(text, "vertex 6", "vertex -6"), {"line 4", "-6"}},
           {"a.ply", with(text, "vertex 6", "vertex 5000000000"), {"line 4", "5000000000", "2^32"}},
           {"a.ply", with(text, "face 8", "face 4000000000"), {"line 8", "4000000000"}},
           {"a.ply", with(text, "face 8", "face 0"), {"no triangles"}},
           {"a.ply", with(text, "element face", "element fake"), {"'face'"}},
           {"a.ply", with(text, "float y", "float u"), {"'y'"}},
           {"a.ply", with(text, "float y", "real y"), {"line 6", "'real'"}},
           {"a.ply", with(text, "vertex_indices", "vertices"), {"vertex_indices"}},
           {"a.ply", with(text, "uchar int", "float int"), {"line 9", "length"}},
           {"a.ply", with(text, "float y", "float x"), {"line 6", "'x'", "twice"}},
           {"a.ply", with(text, "3 0.25 0\n", "3 nan 0\n"), {"y is nan"}},
           {"a.ply", with(text, "3 0.25 0\n", "3 0.25\n"), {"line 11", "missing"}},
           {"a.ply", with(text, "3 0.25 0\n", "3 0.25 zero\n"), {"line 11", "'zero'"}},
           {"a.ply", with(text, "3 0 2 4\n", "3 0 2 6\n"), {"line 17", "6", "out of range"}},
           {"a.ply", with(text, "3 0 2 4\n", "3 0 2 -1\n"), {"line 17", "-1", "out of range"}},
           {"a.ply", with(text, "3 0 2 4\n", "-3 0 2 4\n"), {"line 17", "-3"}},
           {"a.ply", with(text, "3 0 2 4\n", "4 0 2 4\n"), {"line 17", "missing"}},
           {"a.ply", text.substr(0, text.size() - 8), {"cut off", "face 7 of 8"}},
           {"a.ply", little.substr(0, little.size() - 1), {"cut off", "face 7 of 8"}},
           {"a.ply", big.substr(0, big.size() - 200), {"cut off", "vertex"}},
           {"a.ply", nan_vertex, {"vertex 1", "x is nan"}},
           {"a.ply", bad_index, {"face 0", "6", "out of range"}},
           {"a.ply", many, {"face 0", "out of range"}}});
}

TEST_CASE("malformed STL files are refused") {
    const Octahedron o;
    const std::string text = o.stl_ascii(), binary = o.stl_binary();
    std::string infinite = binary, none = binary.substr(0, 84);
    infinite.replace(84 + 50 + 12, 4, raw(-std::numeric_limits<float>::infinity()));
    none.replace(80, 4, raw(std::uint32_t{0}));
    check({{"a.stl", png, {"cut off, or not STL"}},
           {"a.stl", "short", {"5 bytes"}},
           {"a.stl",
            std::string("x") + binary.substr(1, binary.size() - 2),
            {"cut off", "8 triangles take 484 bytes and there are 483"}},
           {"a.stl", infinite, {"triangle 1", "-inf"}},
           {"a.stl", none, {"no triangles"}},
           {"a.stl", "solid nothing\nendsolid nothing\n", {"no triangles"}},
           {"a.stl", text.substr(0, text.find("endsolid")), {"cut off", "endsolid"}},
           {"a.stl", with(text, "vertex 3 0.25 0", "vertex 3 0.25"), {"line 4", "missing"}},
           {"a.stl", with(text, "vertex 3 0.25 0", "vertex 3 0.25 nan"), {"line 4", "'nan'"}},
           {"a.stl", with(text, "vertex 3 0.25 0", "vertex 3 1e60 0"), {"line 4", "'1e60'"}},
           {"a.stl", with(text, "vertex 3 0.25 0\n", "\n"), {"line 7", "2 vertices"}},
           {"a.stl", with(text, "endloop", "endlop"), {"line 7", "'endlop'"}},
           {"a.stl", with(text, "facet normal", "facet nomal"), {"line 2", "'nomal'"}}});
}

TEST_CASE("malformed glTF files are refused") {
    const Octahedron o;
    const std::string text = o.gltf("data:;base64," + base64(o.bin())), glb = o.glb();
    const auto changed = [&](const std::string& old, const std::string& fresh) {
        return with(text, old, fresh);
    };
    std::string nan = o.bin(), index = o.bin();
    nan.replace(16, 4, raw(std::nanf("")));
    index.replace(72 + 2, 2, raw(std::uint16_t{6}));
    check({{"a.gltf", png, {"not glTF"}},
           {"a.glb", png, {"not glTF"}},
           {"a.glb", glb.substr(0, 15), {"cut off"}},
           {"a.glb", glb.substr(0, glb.size() - 4), {"cut off", std::to_string(glb.size())}},
           {"a.glb", with(glb, raw(2), raw(7)), {"version 7"}},
           {"a.glb", with(glb, "JSON", "JSOM"), {"JSON"}},
           {"a.glb", glb_of(o.gltf(""), nan), {"accessors[0]", "element 1", "not finite"}},
           {"a.glb", glb_of(o.gltf(""), index), {"indices", "6", "out of range"}},
           {"a.gltf", text.substr(0, 100), {"line 1", "column 101"}},
           {"a.gltf", changed("\"2.0\"", "\"1.0\""), {"asset.version", "\"1.0\""}},
           {"a.gltf", R"({"asset":{"version":"1.0"},"buffers":{"a":{}}})", {"asset.version", "\"1.0\""}},
           {"a.gltf", changed("\"asset\"", "\"assets\""), {"'asset'"}},
           {"a.gltf",
            changed("\"POSITION\":0", "\"POSITION\":2"),
            {"meshes[0].primitives[0].attributes.POSITION", "2"}},
           {"a.gltf", changed("\"POSITION\":0", "\"POSITION\":1"), {"accessors[1].type", "\"SCALAR\""}},
           {"a.gltf", changed("5126", "5127"), {"accessors[0].componentType", "5127"}},
           {"a.gltf", changed("5123", "5126"), {"accessors[1].componentType", "5126"}},
           {"a.gltf", changed("\"count\":6", "\"count\":7"), {"accessors[0]", "84 bytes", "72"}},
           {"a.gltf", changed("\"count\":24", "\"count\":23"), {"primitives[0]", "23"}},
           {"a.gltf", changed("\"count\":24", "\"count\":-24"), {"accessors[1].count", "-24"}},
           {"a.gltf", changed("\"byteOffset\":72", "\"byteOffset\":99"), {"bufferViews[1]", "147", "120"}},
           {"a.gltf", changed("\"byteLength\":120", "\"byteLength\":121"), {"buffers[0]", "120", "121"}},
           {"a.gltf", changed("base64,A", "base64,?"), {"buffers[0].uri", "'?'"}},
           {"a.gltf", o.gltf(""), {"buffers[0]", "'uri'"}},
           {"a.gltf", changed("\"mesh\":0", "\"mesh\":1"), {"nodes[0].mesh", "1"}},
           {"a.gltf", changed("\"mesh\":0", "\"children\":[0]"), {"nodes[0]", "twice"}},
           {"a.gltf", changed("\"mesh\":0", "\"mesh\":0,\"children\":[4]"), {"nodes[0].children[0]", "4"}},
           {"a.gltf", changed("\"mesh\":0", "\"mesh\":0,\"scale\":[1,2]"), {"nodes[0].scale", "[1,2]"}},
           {"a.gltf",
            changed("\"mesh\":0", "\"mesh\":0,\"scale\":[1,2,\"x\"]"),
            {"nodes[0].scale[2]", "\"x\""}},
           {"a.gltf", changed("\"indices\":1", "\"indices\":1,\"mode\":9"), {"primitives[0].mode", "9"}},
           {"a.gltf", changed("\"indices\":1", "\"indices\":1,\"mode\":1"), {"no triangles"}},
           {"a.gltf",
            changed("\"indices\":1", "\"indices\":1,\"material\":0"),
            {"primitives[0].material", "0"}},
           {"a.gltf",
            changed("\"scene\":0", "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]"),
            {"KHR_draco_mesh_compression"}}});
    const SceneFolder folder;
    CHECK(complaint(folder.write("a.gltf", o.gltf("none.bin"))) ==
          folder.name("none.bin") + ": there is no such file (" + folder.name("a.gltf") +
              ": buffers[0].uri asks for it)");
}

}   // namespace rayclock::test::refused_files_test
