// Truncated and damaged files: each loads or gives a UserError; nothing else may happen.
#include <catch2/catch.hpp>

#include <random>

#include "tests/support/scenes/scene_files.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct Seed {
    std::string name, bytes;
};

std::vector<Seed> seeds() {
    const Octahedron o;
    const std::string quads =
        "mtllib m.mtl\ng a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0.5 0.5 0\nv 0 1 0\nvn 0 0 1\nusemtl red\nf 1//1 "
        "2//1 3//1 4//1 5//1\n"
        "usemtl blue\nf -1 -2 -3\n";
    const std::string json =
        R"({"camera":{"eye":[0,0,9],"at":[0,0,0],"up":[0,1,0],"fov_degrees":40},"lights":[{"position":[1,2,3]}],)"
        R"("materials":{"m":{"colour":[1,0,0],"shine":3}},"meshes":{"a":{"file":"q.obj"},"b":{"builtin":"icosphere:1"}},)"
        R"("objects":[{"mesh":"a","material":"m","rotate":{"axis":[0,1,0],"degrees":30}},{"mesh":"b","scale":[1,-2,3]}]})";
    return {{"q.obj", quads},
            {"a.ply", o.ply_ascii()},
            {"l.ply", o.ply_binary(false)},
            {"b.ply", o.ply_binary(true)},
            {"a.stl", o.stl_ascii()},
            {"b.stl", o.stl_binary()},
            {"a.glb", o.glb()},
            {"a.gltf", o.gltf("data:;base64," + base64(o.bin()))},
            {"a.json", json},
            {"i.json", o.json()}};
}

/// Returns true if it loads. Any other exception ends the test; a crash or a hang does so by itself.
bool survives(const std::string& file) {
    try {
        const Scene scene = load_scene(file);
        check_scene(scene, "loaded");
        REQUIRE(!scene.lights.empty());
        return true;
    } catch (const UserError& error) {
        REQUIRE(std::string(error.what()).find('\n') == std::string::npos);
        return false;
    }
}

}   // namespace

TEST_CASE("every prefix of a file loads or is refused") {
    for (const auto& [name, bytes] : seeds()) {
        const SceneFolder folder;
        folder.write("m.mtl", "newmtl red\nKd 1 0 0\n");
        folder.write("q.obj", seeds()[0].bytes);
        REQUIRE(survives(folder.write(name, bytes)));
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            INFO(name << " cut to " << length << " of " << bytes.size());
            survives(folder.write(name, bytes.substr(0, length)));
        }
    }
}

TEST_CASE("every prefix of a material file loads or is refused") {
    const SceneFolder folder;
    const std::string bytes = "newmtl red\nKd 0.5 0.25 1\nKs 1 1 1\nNs 20\nd 0.5\nNi 1.5\nillum 3\n";
    for (std::size_t length = 1; length <= bytes.size(); ++length) {
        folder.write("m.mtl", bytes.substr(0, length));
        survives(folder.write("q.obj", seeds()[0].bytes));
    }
}

TEST_CASE("damaged bytes load or are refused") {
    const unsigned seed = 20240229;
    std::mt19937 random(seed);
    for (const auto& [name, bytes] : seeds()) {
        const SceneFolder folder;
        folder.write("m.mtl", "newmtl red\nKd 1 0 0\n");
        folder.write("q.obj", seeds()[0].bytes);
        int loaded = 0;
        for (int round = 0; round < 400; ++round) {
            std::string damaged = bytes;
            // Digits and blanks in addition to any byte: they pass the grammar and reach the code behind it.
            const std::string likely = "0123456789- .\n9/";
            for (int k = static_cast<int>(random() % 3); k >= 0; --k)
                damaged[random() % damaged.size()] =
                    random() % 2 ? static_cast<char>(random()) : likely[random() % likely.size()];
            INFO(name << " round " << round << " seed " << seed);
            loaded += survives(folder.write(name, damaged));
        }
        INFO(name);
        CHECK(loaded > 0);   // otherwise the damage never passes the first check
        CHECK(loaded < 400);
    }
}
