// Files that Assimp reads: their results, and that none of its faults harms this program. Fake programs in
// its place hang, crash, flood the output, and report their limits.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <glm/geometric.hpp>

#include "sim/files/image/image.hpp"
#include "sim/load/import/assimp.hpp"
#include "sim/files/process/process.hpp"
#include "tests/support/scenes/scene_files.hpp"

using namespace rayclock;
using namespace rayclock::test;
using Catch::Contains;

namespace {

const char* const x3d =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<X3D version="3.0" profile="Interchange"><Scene><Transform translation="1 0 0"><Shape>
<Appearance><Material diffuseColor="1 0.5 0" transparency="0.25"/></Appearance>
<IndexedFaceSet coordIndex="0 2 1 -1 0 1 3 -1">
<Coordinate point="0 0 0 2 0 0 0 1 0 0 0 0.5"/></IndexedFaceSet>
</Shape></Transform></Scene></X3D>)";
const std::vector<Corners> x3d_triangles{{{{1, 0, 0}, {1, 1, 0}, {3, 0, 0}}},
                                         {{{1, 0, 0}, {3, 0, 0}, {1, 0, 0.5}}}};

/// A folder first in PATH, with a shell script in place of Assimp.
class FakeAssimp {
public:
    explicit FakeAssimp(const std::string& script) : path_(std::getenv("PATH")) {
        namespace fs = std::filesystem;
        const std::string file = folder_.write("assimp", "#!/bin/sh\n" + script + "\n");
        fs::permissions(file, fs::perms::owner_all);
        setenv("PATH", (fs::path(file).parent_path().string() + ":" + path_).c_str(), 1);
    }
    ~FakeAssimp() { setenv("PATH", path_.c_str(), 1); }

private:
    SceneFolder folder_;
    std::string path_;
};

std::string said_with(const std::string& script) {
    const FakeAssimp fake(script);
    const SceneFolder folder;
    const std::string said = complaint(folder.write("a.x3d", x3d));
    INFO(said);
    CHECK(said.find('\n') == said.npos);
    CHECK_THAT(said, Contains("a.x3d: "));
    return said;
}

bool is_there() { return !find_program(assimp_program).empty(); }

}   // namespace

TEST_CASE("assimp: a file of another kind is drawn where its author put it, packed or not") {
    if (!is_there()) return;   // without Assimp nothing can be tested
    const SceneFolder folder;
    for (const auto& [name, bytes] :
         {std::pair("a.x3d", std::string(x3d)), std::pair("a.x3d.gz", gz_of(x3d))}) {
        std::vector<std::string> notes;
        const Scene scene = load_scene(folder.write(name, bytes), {}, Primitives::triangles, &notes);
        CHECK(corners_of(scene) == x3d_triangles);
        REQUIRE(scene.materials.size() == 1);
        CHECK(scene.materials[0].colour == glm::dvec3(1, 0.5, 0));
        // Assimp 5.4 writes that a material is transparent, but not how much.
        const bool is_told = std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
            return note.find("drawn opaque") != std::string::npos;
        });
        CHECK((scene.materials[0].transmit == Approx(0.25) || is_told));
    }
    const std::string said = complaint(folder.write("b.fbx", "Dear Sir or Madam"));
    CHECK_THAT(said, Contains("b.fbx: Assimp cannot read it: ") && !Contains("ERROR"));
}

TEST_CASE("assimp: pictures keep their coordinates, and t increases upwards in AC3D") {
    if (!is_there()) return;   // without Assimp nothing can be tested
    const SceneFolder folder;
    folder.write("p.png", png_bytes({{2, 2}, {{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}));
    const Scene scene = folder.load("a.ac", R"(AC3Db
MATERIAL "m" rgb 1 1 1 amb 1 1 1 emis 0 0 0 spec 0 0 0 shi 0 trans 0
OBJECT world
kids 1
OBJECT poly
texture "p.png"
numvert 3
0 0 0
1 0 0
0 1 0
numsurf 1
SURF 0x20
mat 0
refs 3
0 0 0
1 0.75 0
2 0 0.5
kids 0
)");
    REQUIRE(scene.textures.size() == 1);
    REQUIRE(scene.coordinates.size() == 1);
    CHECK(scene.textures[0].pyramid->levels[0].texels[1] == std::array<std::uint8_t, 4>{255, 0, 0, 255});
    const Corners corners = corners_of(scene).at(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 wanted(0.75 * corners[k].x, 1 - 0.5 * corners[k].y);
        CHECK(glm::length(scene.coordinates[0][k] - wanted) < 1e-6);
    }
}

TEST_CASE("assimp: a file name is one argument, whatever its characters") {
    if (!is_there()) return;   // without Assimp nothing can be tested
    const SceneFolder folder;
    CHECK(folder.load("a $(touch x) ; -b.x3d", x3d).triangles.size() == 2);
    CHECK(folder.load("-fobj.x3d", x3d).triangles.size() == 2);
}

TEST_CASE("assimp: what it does wrong becomes a sentence") {
    CHECK_THAT(said_with("echo 'ERROR: no such mesh'; exit 10"),
               Contains("Assimp cannot read it: no such mesh"));
    CHECK_THAT(said_with("exit 0"), Contains("Assimp cannot read it"));
    CHECK_THAT(said_with("kill -SEGV $$"),
               Contains("crashed, or needed more than 10 s, 2048 MB of memory or 256 MB"));
    CHECK_THAT(said_with("echo no glTF > \"$3\""), Contains("a.x3d: "));
    CHECK_THAT(said_with("printf '\\033[31mERROR: \\007bell'; exit 1"),
               !Contains("\033") && !Contains("\007"));
    // Neither its result nor its output fills the disk: it is ended at 256 MB.
    CHECK_THAT(said_with("head -c 400000000 /dev/zero > \"$3\" || exit 3"), Contains("a.x3d: "));
    // Processor time in seconds, memory in kB, and the largest file in blocks of 512 bytes.
    CHECK_THAT(said_with("echo ERROR: $(ulimit -t) $(ulimit -v) $(ulimit -f); exit 1"),
               Contains(": 10 2097152 524288"));
}

TEST_CASE("assimp: without it a sentence says what to install") {
    const SceneFolder folder;
    const std::string file = folder.write("a.fbx", "Kaydara FBX Binary"), path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    const std::string said = complaint(file);
    setenv("PATH", path.c_str(), 1);
    CHECK_THAT(said, Contains("a.fbx: ") && Contains("Assimp, which is not installed; install assimp-utils"));
    CHECK_THAT(complaint(folder.write("a.xyz", "1 2 3")), Contains("not a kind of file"));
}
