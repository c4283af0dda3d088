// Pictures of 3DS: their chunks, placement and coordinates. Four formats show one picture in the same way.
#include <catch2/catch.hpp>

#include <limits>

#include <glm/common.hpp>

#include "tests/load/textures/textured_scenes.hpp"

namespace rayclock::test::tds_textures_test {

using namespace rayclock;
using namespace rayclock::test;
using Catch::Contains;

namespace {

std::string word(int value) { return raw(static_cast<std::uint16_t>(value)); }

/// A texture map: the chunk with the name of its file, and other chunks.
std::string map_of(const std::string& file, const std::string& more = {}) {
    return chunk(0xa200, chunk(0xa300, file + '\0') + more);
}

using Points = std::vector<std::array<float, 2>>;
const Points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// A square in the plane of x and y, seen from above z, with the material m.
std::string tds(const std::string& maps, const Points& coordinates = square) {
    std::string positions = word(4), sts = word(int(coordinates.size())), faces = word(2);
    for (const auto& [x, y] : square) positions += raw(x) + raw(-0.f) + raw(y);   // z is up in 3DS
    for (const auto& [s, t] : coordinates) sts += raw(s) + raw(t);
    for (const int corner : {0, 1, 2, 0, 0, 2, 3, 0}) faces += word(corner);
    faces += chunk(0x4130, std::string("m\0", 2) + word(2) + word(0) + word(1));
    const std::string mesh = chunk(0x4110, positions) +
                             (coordinates.empty() ? std::string() : chunk(0x4140, sts)) +
                             chunk(0x4120, faces);
    const std::string material =
        chunk(0xafff, chunk(0xa000, std::string("m\0", 2)) +
                          chunk(0xa020, chunk(0x0011, std::string("\x80\0\0", 3))) + maps);
    return chunk(0x4d4d,
                 chunk(0x3d3d, chunk(0x4000, std::string("box\0", 4) + chunk(0x4100, mesh)) + material));
}

LoadedScene read(const SceneFolder& folder, const std::string& bytes, Textures textures = Textures::drawn) {
    folder.write("p.png", four_texels());
    return read_scene(folder.write("a.3ds", bytes), textures);
}
std::string refusal(const std::string& bytes) { return refusal_of("a.3ds", bytes); }

}   // namespace

TEST_CASE("3ds: a picture replaces the diffuse colour, and t increases upwards") {
    const SceneFolder folder;
    const LoadedScene made = read(folder, tds(map_of("P.PNG", chunk(0x0030, word(100)))));
    CHECK(made.notes.empty());   // the case of names does not matter
    CHECK(made.material().colour == glm::dvec3(1));
    CHECK((made.texture().wrap_s == Wrap::repeat && made.texture().wrap_t == Wrap::repeat));
    check_coordinates(made.scene);
    CHECK(read(folder, tds(map_of("C:\\MAPS\\P.PNG"))).material().texture);
    CHECK(read(folder, tds("")).material().colour.r == Approx(128 / 255.0));
}

TEST_CASE("3ds: scale, offset and tiling of a picture are read") {
    const SceneFolder folder;
    // The shift into the first period removes whole offsets, so these are fractions.
    LoadedScene made =
        read(folder, tds(map_of("p.png", chunk(0xa354, raw(0.5f)) + chunk(0xa356, raw(0.25f)) +
                                             chunk(0xa358, raw(0.125f)) + chunk(0xa35a, raw(0.25f)))));
    check_coordinates(made.scene, {0.5, 0.25}, {0.125, 0.25});
    CHECK(made.notes.empty());
    made = read(folder, tds(map_of("p.png", chunk(0xa351, word(2)))));
    CHECK((made.texture().wrap_s == Wrap::mirror && made.texture().wrap_t == Wrap::mirror));
    CHECK(made.notes.empty());
    made = read(folder, tds(map_of("p.png", chunk(0xa351, word(0x10)))));
    CHECK((made.texture().wrap_s == Wrap::clamp && made.texture().wrap_t == Wrap::clamp));
    CHECK(made.notes == Notes{folder.name("a.3ds") +
                              ": 1 picture that does not repeat, drawn clamped to its edge ('p.png')"});
    made = read(folder, tds(map_of("p.png", chunk(0x0031, raw(0.5f)) + chunk(0xa35c, raw(90.f))) +
                            chunk(0xa230, chunk(0xa300, std::string("p.png\0", 6)))));
    REQUIRE(made.notes.size() == 3);
    CHECK_THAT(made.notes[0], Contains("mixed with a colour, drawn alone"));
    CHECK_THAT(made.notes[1], Contains("turned, drawn upright"));
    CHECK_THAT(made.notes[2], Contains("1 material with other textures, which are not drawn ('m')"));
}

TEST_CASE("3ds: without a picture, without coordinates and with --no-textures one colour is drawn") {
    const SceneFolder folder;
    LoadedScene made = read(folder, tds(map_of("none.png")));
    CHECK(made.notes == Notes{folder.name("a.3ds") + ": a picture is not drawn: " + folder.name("none.png") +
                              ": there is no such file"});
    CHECK(made.material().colour.r == Approx(128 / 255.0));
    CHECK(made.scene.coordinates.empty());
    made = read(folder, tds(map_of("p.png"), {}));
    CHECK(glm::length(made.material().colour - glm::dvec3(0.5)) < 1e-12);
    REQUIRE(made.notes.size() == 1);
    CHECK_THAT(made.notes[0], Contains("2 triangles with a texture and without texture coordinates"));
    made = read(folder, tds(map_of("p.png")), Textures::averaged);
    CHECK(glm::length(made.material().colour - glm::dvec3(0.5)) < 1e-6);
    CHECK(made.notes ==
          Notes{folder.name("a.3ds") +
                ": 1 material with a texture of its colour, drawn in the texture's average colour "
                "('m')"});
}

TEST_CASE("3ds: wrong coordinates are refused, if a picture needs them") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const auto& [points, sentence] :
         {std::pair(Points{{0, 0}, {1, 0}, {nan, 1}, {0, 1}},
                    "the mesh 'box' has the texture coordinate nan at vertex 2; the most is 1000000"),
          {Points{{0, 0}, {1, 0}, {1, 1}, {0, -1e9f}}, "the texture coordinate -1000000000 at vertex 3"},
          {Points{{0, 0}, {1, 0}, {1, 1}}, "the mesh 'box' has 3 texture coordinates for 4 vertices"},
          {Points{{0, 0}, {99, 0}, {300, 1}, {0, 1}},
           "triangle 0 (counted from 0) has texture coordinates"}}) {
        INFO(sentence);
        CHECK_THAT(refusal(tds(map_of("p.png"), points)), Contains("a.3ds: ") && Contains(sentence));
        CHECK(refusal(tds(map_of("none.png"), points)).empty());
    }
    const std::string cut = tds(map_of("p.png"), square);
    std::string longer = cut;   // one more coordinate than the chunk holds
    const std::size_t at = longer.find(std::string("\x40\x41", 2));
    longer[at + 6] = 5;
    CHECK_THAT(refusal(longer), Contains("a.3ds: the file is cut off"));
    CHECK_THAT(refusal(tds(chunk(0xa200, chunk(0xa300, "p.png")))), Contains("a name without an end"));
}

TEST_CASE("3ds: every changed byte of a file with a picture loads or is refused") {
    const SceneFolder folder;
    folder.write("p.png", four_texels());
    const std::string sound = tds(map_of("p.png", chunk(0xa351, word(2)) + chunk(0xa354, raw(0.5f))));
    std::size_t drawn = 0, refused = 0;
    for (std::size_t i = 0; i < 8 * sound.size(); i += 5) {
        std::string changed = sound;
        changed[i / 8] = char(changed[i / 8] ^ (1 << (i % 8)));
        const std::string said = complaint(folder.write("a.3ds", changed));
        refused += !said.empty(), drawn += said.empty();
        REQUIRE(said.find('\n') == said.npos);
    }
    CHECK(drawn > 100);
    CHECK(refused > 100);
}

TEST_CASE("obj, glTF, dae and 3ds show the corners of a picture at the same places") {
    const SceneFolder folder;
    folder.write("p.png", four_texels());
    folder.write("a.mtl", "newmtl a\nmap_Kd p.png\n");
    const std::string obj =
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
        "usemtl a\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
    std::string bytes;
    for (const auto& [x, y] : square) bytes += raw(x) + raw(y) + raw(0.f);
    for (const auto& [s, t] : square) bytes += raw(s) + raw(1 - t);   // t increases downwards in glTF
    for (const int corner : {0, 1, 2, 0, 2, 3}) bytes += word(corner);
    const std::string gltf =
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":92,"uri":"data:;base64,)" + base64(bytes) +
        R"("}],"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":32},)"
        R"({"buffer":0,"byteOffset":80,"byteLength":12}],"accessors":[)"
        R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
        R"({"bufferView":1,"componentType":5126,"count":4,"type":"VEC2"},)"
        R"({"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"}],"images":[{"uri":"p.png"}],)"
        R"("textures":[{"source":0}],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]}],)"
        R"("nodes":[{"mesh":0}]})";
    const std::string dae =
        R"(<COLLADA><library_images><image id="i"><init_from>p.png</init_from></image></library_images>)"
        R"(<library_effects><effect id="e"><profile_COMMON><technique><lambert><diffuse><texture texture="i")"
        R"( texcoord="u"/></diffuse></lambert></technique></profile_COMMON></effect></library_effects>)"
        R"(<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>)"
        R"(<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa">0 0 0 1 0 0 1 1 0)"
        R"( 0 1 0</float_array><technique_common><accessor source="#pa" count="4" stride="3"/>)"
        R"(</technique_common></source><source id="t"><float_array id="ta">0 0 1 0 1 1 0 1</float_array>)"
        R"(<technique_common><accessor source="#ta" count="4" stride="2"/></technique_common></source>)"
        R"(<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles material="s"><input)"
        R"( semantic="VERTEX" source="#v" offset="0"/><input semantic="TEXCOORD" source="#t" offset="0"/>)"
        R"(<p>0 1 2 0 2 3</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>)"
        R"(<visual_scene id="V"><node><instance_geometry url="#g"><bind_material><technique_common>)"
        R"(<instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry>)"
        R"(</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#V"/></scene>)"
        R"(</COLLADA>)";
    const std::vector<std::pair<const char*, std::string>> files{
        {"a.obj", obj}, {"a.gltf", gltf}, {"a.dae", dae}, {"a.3ds", tds(map_of("p.png"))}};
    // The picture's rows, from the top: white, red; green, blue.
    const std::vector<std::pair<glm::dvec3, glm::dvec3>> wanted{
        {{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {0, 0, 1}}, {{1, 1, 0}, {1, 0, 0}}, {{0, 1, 0}, {1, 1, 1}}};
    for (const auto& [name, text] : files) {
        INFO(name);
        Notes notes;
        const Scene scene = load_scene(folder.write(name, text), {}, Primitives::triangles, &notes);
        CHECK(notes.empty());
        const std::vector<Corners> corners = corners_of(scene);
        REQUIRE(corners.size() == 2);
        int compared = 0;
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                for (const auto& [place, colour] : wanted)
                    if (corners[i][k] == place) {
                        Texture texture =
                            scene.textures.at(scene.materials[scene.triangles[i].material].texture.value());
                        texture.nearest = true;
                        // A hundredth of the picture inwards from the corner.
                        const glm::dvec2 inside = glm::mix(scene.coordinates[i][k], glm::dvec2(0.5), 0.02);
                        CHECK(filtered(texture, inside, 0) == colour);
                        ++compared;
                    }
        CHECK(compared == 6);
    }
}

}   // namespace rayclock::test::tds_textures_test
