// OFF, 3DS, DAE, gzip, and the textures of glTF: accepted files, and the messages for refused ones.
#include <catch2/catch.hpp>

#include <limits>

#include <glm/geometric.hpp>

#include "sim/files/image/image.hpp"
#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test::off_3ds_dae_gzip_test {

using namespace rayclock;
using namespace rayclock::test;
using Catch::Contains;

namespace {

struct Told {
    Scene scene;
    std::vector<std::string> notes;
};
Told told(const SceneFolder& folder, const std::string& name, const std::string& bytes,
          Textures textures = Textures::drawn) {
    Told all;
    all.scene = load_scene(folder.write(name, bytes), {}, Primitives::triangles, &all.notes, textures);
    return all;
}
void check_refused(const std::string& name, const std::string& bytes, const std::vector<std::string>& words) {
    const SceneFolder folder;
    const std::string said = complaint(folder.write(name, bytes));
    INFO(name << ": " << bytes.substr(0, 200));
    CHECK_THAT(said, Contains(name));
    CHECK(said.find('\n') == said.npos);
    for (const std::string& word : words) CHECK_THAT(said, Contains(word));
}
std::string replaced(std::string text, const std::string& from, const std::string& to) {
    REQUIRE(text.find(from) != text.npos);
    return text.replace(text.find(from), from.size(), to);
}
std::string word(int value) { return raw(static_cast<std::uint16_t>(value)); }
constexpr const char* tetrahedron = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

}   // namespace

TEST_CASE("off: counts on the keyword's line, comments, polygons, normals and colours are read") {
    const SceneFolder folder;
    CHECK(folder.load("a.off", std::string("OFF 4 4 6 # so many\n\n# nothing\n") + tetrahedron)
              .triangles.size() == 4);
    const Told quad =
        told(folder, "q.off",
             "COFF\n4 2 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n1 1 0 1 0 0 1\n0 1 0 1 0 0 1\n4 0 1 2 3\n2 0 1\n");
    CHECK(quad.scene.triangles.size() == 2);
    REQUIRE(quad.notes.size() == 1);
    CHECK_THAT(quad.notes[0], Contains("its colours are not drawn"));
    // ModelNet has no blank between the keyword and the counts.
    CHECK(folder.load("g.off", std::string("OFF4 4 6\n") + tetrahedron).triangles.size() == 4);
    CHECK(folder.load("h.off", "COFF3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2\n")
              .triangles.size() == 1);
    const Scene smooth =
        folder.load("n.off", "NOFF\n3 1 0\n0 0 0 0 0 2\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n");
    REQUIRE(smooth.normals.size() == 3);
    CHECK(smooth.normals[0] == glm::dvec3(0, 0, 1));
}

TEST_CASE("off: what makes no sense is refused with its line") {
    const std::string rest = tetrahedron;
    check_refused("a.off", "solid x\n" + rest, {"line 1", "this is not OFF", "'solid'"});
    check_refused("a.off", "4OFF\n4 4 6\n" + rest, {"line 1", "'4OFF' cannot be read"});
    check_refused("a.off", "OFF BINARY\n4 4 6\n", {"binary OFF"});
    check_refused("a.off", "OFF\n-4 4 6\n" + rest, {"line 2", "-4 vertices"});
    check_refused("a.off", "OFF\n4000000000 4 6\n" + rest, {"cut off"});
    check_refused("a.off", "OFF\n4 5 6\n" + rest, {"cut off: a face is missing"});
    check_refused("a.off", "OFF\n4 4 6\n" + replaced(rest, "3 0 2 1", "3 0 2 4"),
                  {"line 7", "vertex index 4", "has 4"});
    check_refused("a.off", "OFF\n4 4 6\n" + replaced(rest, "3 0 2 1", "3 0 2"),
                  {"line 7", "3 corners, and 2"});
    check_refused("a.off", "OFF\n4 4 6\n" + replaced(rest, "1 0 0", "1 nan 0"), {"line 4", "'nan'"});
    check_refused("a.off", "OFF\n4 4 6\n" + replaced(rest, "1 0 0", "1 0"), {"line 4", "too few numbers"});
    check_refused("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n2 0 1\n", {"no triangles"});
}

TEST_CASE("3ds: faces keep their materials and the order of the file") {
    const SceneFolder folder;
    const std::string red =
        chunk(0xafff, chunk(0xa000, std::string("red\0", 4)) +
                          chunk(0xa020, chunk(0x0011, std::string("\xff\0\0", 3))) + chunk(0xa200, ""));
    std::string bytes = Octahedron().tds();
    // The chunks around the faces grow by the chunk of their material.
    const std::string faces = bytes.substr(bytes.find(std::string("\x20\x41", 2)));
    const std::string of_faces =
        chunk(0x4130, std::string("red\0", 4) + raw(std::uint16_t{1}) + raw(std::uint16_t{3}));
    const std::string corners = bytes.substr(bytes.find(std::string("\x10\x41", 2)), 6 + 2 + 72);
    const std::string object = chunk(
        0x4000, std::string("o\0", 2) + chunk(0x4100, corners + chunk(0x4120, faces.substr(6) + of_faces)));
    const Told told_3ds =
        told(folder, "m.3ds", chunk(0x4d4d, chunk(0x3d3d, red + object) + chunk(0xb000, "")));
    const Scene& scene = told_3ds.scene;
    REQUIRE(scene.triangles.size() == 8);
    REQUIRE(scene.materials.size() == 2);
    CHECK(scene.materials[scene.triangles[3].material].name == "red");
    CHECK(scene.materials[scene.triangles[3].material].colour == glm::dvec3(1, 0, 0));
    CHECK(scene.materials[scene.triangles[2].material].name == "default");
    CHECK(scene.triangles[4].material == scene.triangles[2].material);
    REQUIRE(told_3ds.notes.size() == 2);
    CHECK_THAT(told_3ds.notes[0], Contains("1 material with other textures"));
    CHECK_THAT(told_3ds.notes[1], Contains("key frames"));
}

TEST_CASE("3ds: a colour that is not a number counts as 0, with a note") {
    const SceneFolder folder;
    std::string colour;
    for (const float x : {std::numeric_limits<float>::quiet_NaN(), 0.5f, 7.0f}) colour += raw(x);
    const std::string material =
        chunk(0xafff, chunk(0xa000, std::string("m\0", 2)) + chunk(0xa020, chunk(0x0010, colour)) +
                          chunk(0xa030, chunk(0x0010, colour)));
    const std::string faces = word(1) + word(0) + word(1) + word(2) + word(0) +
                              chunk(0x4130, std::string("m\0", 2) + word(1) + word(0));
    std::string positions = word(3);
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f, 1.f}) positions += raw(x);
    const std::string mesh = chunk(0x4100, chunk(0x4110, positions) + chunk(0x4120, faces));
    const Told made =
        told(folder, "a.3ds",
             chunk(0x4d4d, chunk(0x3d3d, material + chunk(0x4000, std::string("o\0", 2) + mesh))));
    CHECK(made.scene.materials.at(0).colour == glm::dvec3(0, 0.5, 1));
    CHECK(made.scene.materials.at(0).highlight == 1);
    REQUIRE(made.notes.size() == 1);
    CHECK_THAT(made.notes[0], Contains("1 material with values out of range"));
}

TEST_CASE("3ds: what makes no sense is refused") {
    const std::string sound = Octahedron().tds();
    check_refused("a.3ds", "Dear Sir or Madam", {"chunk"});
    check_refused("a.3ds", "\x4d", {"cut off"});
    check_refused("a.3ds", chunk(0x4d4e, ""), {"this is not 3DS", "4d4e"});
    check_refused("a.3ds", chunk(0x4d4d, ""), {"no triangles"});
    check_refused("a.3ds", sound.substr(0, sound.size() - 1), {"bytes, and"});
    check_refused("a.3ds", replaced(sound, raw(0.25f), raw(std::numeric_limits<float>::quiet_NaN())),
                  {"not a finite number"});
    const std::string face = raw(std::uint16_t{0}) + raw(std::uint16_t{2}) + raw(std::uint16_t{4});
    check_refused(
        "a.3ds", replaced(sound, face, raw(std::uint16_t{0}) + raw(std::uint16_t{2}) + raw(std::uint16_t{6})),
        {"vertex index 6 is out of range", "has 6"});
}

TEST_CASE("dae: nodes with transforms, copies of nodes, colours of materials, polygons and strips are read") {
    const SceneFolder folder;
    const std::string library =
        "<library_effects><effect id=\"e\"><profile_COMMON><technique sid=\"t\"><phong><diffuse><color>1 0.5 "
        "0 1</color>"
        "</diffuse></phong></technique></profile_COMMON></effect></"
        "library_effects><library_materials><material id=\"m\" "
        "name=\"orange\"><instance_effect url=\"#e\"/></material></library_materials><library_nodes><node "
        "id=\"n\">"
        "<scale>2 2 2</scale><instance_geometry url=\"#g\"/></node></library_nodes><library_geometries>";
    std::string text = replaced(Octahedron().dae("Y_UP"), "<library_geometries>", library);
    text = replaced(text, "<triangles count=\"8\">", "<triangles count=\"8\" material=\"s\">");
    text = replaced(
        text, "<instance_geometry url=\"#g\"/></node></visual",
        "<translate>10 0 0</translate><rotate>0 0 1 90</rotate><instance_geometry url=\"#g\"><bind_material>"
        "<technique_common><instance_material symbol=\"s\" target=\"#m\"/></technique_common></bind_material>"
        "</instance_geometry><node><matrix>1 0 0 1 0 1 0 2 0 0 1 3 0 0 0 1</matrix><instance_node "
        "url=\"#n\"/>"
        "</node></node></visual");
    const Scene scene = folder.load("a.dae", text);
    REQUIRE(scene.triangles.size() == 16);
    const Octahedron o;
    const auto turned = [](const glm::dvec3& p) { return glm::dvec3(10 - p.y, p.x, p.z); };
    const auto near = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < 1e-12; };
    for (std::size_t t = 0; t < 8; ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 p = o.vertices[o.triangles[t][k]];
            CHECK(near(corners_of(scene)[t][k], turned(p)));
            CHECK(near(corners_of(scene)[8 + t][k], turned(2.0 * p + glm::dvec3(1, 2, 3))));
        }
    CHECK(scene.materials[scene.triangles[0].material].name == "orange");
    CHECK(scene.materials[scene.triangles[0].material].colour == glm::dvec3(1, 0.5, 0));
    CHECK(scene.materials[scene.triangles[8].material].name == "default");

    const std::string input = "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>";
    std::string other = Octahedron().dae("Y_UP");
    other = replaced(other, "</triangles>",
                     "</triangles><polylist count=\"2\">" + input +
                         "<vcount>4 3</vcount><p>0 2 1 3 0 2 4</p></polylist><polygons>" + input +
                         "<p>0 2 4</p><p>2 1 4</p></polygons><tristrips>" + input +
                         "<p>0 2 4 1</p></tristrips><trifans>" + input + "<p>4 0 2 1</p></trifans><lines>" +
                         input + "<p>0 1</p></lines>");
    const Told many = told(folder, "b.dae", other);
    CHECK(many.scene.triangles.size() == 8 + 3 + 2 + 2 + 2);
    REQUIRE(many.notes.size() == 1);
    CHECK_THAT(many.notes[0], Contains("1 primitive of lines"));
}

TEST_CASE("dae: what makes no sense is refused with its line") {
    const std::string sound = Octahedron().dae("Y_UP");
    check_refused("a.dae", "<x/>", {"this is not COLLADA", "'x'"});
    check_refused("a.dae", "Dear Sir", {"line 1", "not XML"});
    check_refused("a.dae", sound.substr(0, sound.size() / 2), {"not XML"});
    check_refused("a.dae", replaced(sound, "<COLLADA", "<!DOCTYPE a [<!ENTITY b \"c\">]><COLLADA"),
                  {"document type"});
    check_refused("a.dae", replaced(sound, "0 2 4\n", "0 2 6\n"),
                  {"line", "vertex index 6", "6 (0 is the first)"});
    check_refused("a.dae", replaced(sound, "0 2 4\n", "0 -2 4\n"), {"index -2"});
    check_refused("a.dae", replaced(sound, "count=\"6\"", "count=\"7\""), {"go beyond the 18 numbers"});
    check_refused("a.dae", replaced(sound, "stride=\"3\"", "stride=\"2\""), {"stride of 2"});
    check_refused("a.dae", replaced(sound, "url=\"#g\"", "url=\"#h\""), {"'#h'", "not in the file"});
    check_refused("a.dae", replaced(sound, "<node>", "<node id=\"n\"><instance_node url=\"#n\"/>"),
                  {"nested deeper than 500"});
    check_refused("a.dae", replaced(sound, "<node>", "<node><matrix>1 2 3</matrix>"),
                  {"matrix of 3 numbers instead of 16"});
    std::string deep;
    for (int i = 0; i < 700; ++i) deep += "<a>";
    check_refused("a.dae", deep, {"nested deeper"});
    // Every level draws the one below it ten times.
    std::string bomb;
    for (int i = 0; i < 12; ++i) {
        bomb += "<node id=\"b" + std::to_string(i) + "\">";
        for (int k = 0; k < 10; ++k)
            bomb += i == 0 ? "<instance_geometry url=\"#g\"/>"
                           : "<instance_node url=\"#b" + std::to_string(i - 1) + "\"/>";
        bomb += "</node>";
    }
    check_refused(
        "a.dae",
        replaced(replaced(sound, "<library_geometries>",
                          "<library_nodes>" + bomb + "</library_nodes><library_geometries>"),
                 "<node><instance_geometry", "<node><instance_node url=\"#b11\"/><instance_geometry"),
        {"MB of"});
}

TEST_CASE("gzip: data that are damaged, cut off or followed by others are refused") {
    const std::string sound = gz_of(Octahedron().obj());
    check_refused("a.obj.gz", Octahedron().obj(), {"not gzip"});
    check_refused("a.obj.gz", sound.substr(0, sound.size() - 9), {"cut off"});
    check_refused("a.obj.gz", sound.substr(0, 12), {"cut off"});
    std::string damaged = sound;
    damaged[damaged.size() - 6] = char(damaged[damaged.size() - 6] ^ 1);   // a byte of the checksum
    check_refused("a.obj.gz", damaged, {"damaged"});
    check_refused("a.obj.gz", sound + "more", {"damaged"});
    check_refused("a.obj.gz", gz_of(""), {"empty"});
    check_refused("a.gif.gz", sound, {"not a kind of file"});
    check_refused("a.gz", sound, {"not a kind of file"});
}

TEST_CASE(
    "glTF: --no-textures draws the mean of the base colour's texture, from a file, from inside, or none") {
    const SceneFolder folder;
    Picture picture{{2, 1}, {{1, 0, 0.25f}, {0, 0, 0.25f}}};
    const std::string png = png_bytes(picture);
    folder.write("mean.png", png);
    const auto with = [](const std::string& image) {
        std::string text = Octahedron().gltf("data:;base64," + base64(Octahedron().bin()));
        text = replaced(text, "\"indices\":1", "\"indices\":1,\"material\":0");
        return replaced(text, "\"accessors\"",
                        "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0},"
                        "\"metallicFactor\":0,"
                        "\"baseColorFactor\":[1,1,0.5,1]}}],\"textures\":[{\"source\":0}],\"images\":[" +
                            image + "],\"accessors\"");
    };
    const Told outside = told(folder, "outside.gltf", with("{\"uri\":\"mean.png\"}"), Textures::averaged);
    const glm::dvec3 colour = outside.scene.materials.at(0).colour;
    CHECK(colour.r == Approx(0.5).epsilon(1e-3));
    CHECK(colour.g == 0);
    CHECK(colour.b == Approx(0.125).epsilon(0.01));   // 8 bits of sRGB
    REQUIRE(outside.notes.size() == 1);
    CHECK_THAT(outside.notes[0],
               Contains("1 material with a texture of its colour, drawn in the texture's average colour"));
    const Told inside =
        told(folder, "inside.gltf", with("{\"uri\":\"data:image/png;base64," + base64(png) + "\"}"),
             Textures::averaged);
    CHECK(inside.scene.materials.at(0).colour == colour);

    const Told none = told(folder, "none.gltf", with("{\"uri\":\"none.png\"}"));
    CHECK(none.scene.materials.at(0).colour == glm::dvec3(1, 1, 0.5));
    REQUIRE(none.notes.size() == 1);
    CHECK_THAT(none.notes[0], Contains("images[0] is not drawn") && Contains("none.png"));
    folder.write("no.png", "GIF89a and so on");
    CHECK_THAT(told(folder, "no.gltf", with("{\"uri\":\"no.png\"}")).notes.at(0),
               Contains("it is not PNG, JPEG, BMP"));
    folder.write("cut.png", png.substr(0, png.size() / 2));
    CHECK(told(folder, "cut.gltf", with("{\"uri\":\"cut.png\"}")).notes.size() == 1);
    check_refused("up.gltf", with("{\"uri\":\"../secret.png\"}"), {"outside the folder"});
    check_refused("far.gltf", replaced(with("{\"uri\":\"mean.png\"}"), "\"source\":0", "\"source\":3"),
                  {"source"});
}

TEST_CASE("every prefix and every changed byte of the other formats loads or is refused") {
    const SceneFolder folder;
    const Octahedron o;
    const std::vector<std::pair<std::string, std::string>> files{
        {"a.off", o.off()}, {"a.3ds", o.tds()}, {"a.dae", o.dae("Z_UP")}, {"a.off.gz", gz_of(o.off())}};
    for (const auto& [name, bytes] : files) {
        INFO(name);
        std::size_t loaded = 0;
        const auto attempt = [&](const std::string& changed) {
            const std::string said = complaint(folder.write(name, changed));
            loaded += said.empty();
            REQUIRE(said.find('\n') == said.npos);
        };
        for (std::size_t length = 1; length < bytes.size(); length += 1 + bytes.size() / 400)
            attempt(bytes.substr(0, length));
        for (std::size_t i = 0; i < bytes.size(); i += 1 + bytes.size() / 400) {
            std::string changed = bytes;
            changed[i] = char(changed[i] ^ (1 << (i % 8)));
            attempt(changed);
        }
        CHECK(loaded > 0);
    }
}

}   // namespace rayclock::test::off_3ds_dae_gzip_test
