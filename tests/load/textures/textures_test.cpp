// Textures from files: coordinates in OBJ, glTF and JSON, samplers, transforms, missing or invalid pictures,
// and --no-textures.
#include <algorithm>
#include <array>
#include <cmath>

#include <catch2/catch.hpp>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "model/scene/placed.hpp"
#include "sim/files/image/average.hpp"
#include "tests/load/textures/textured_scenes.hpp"
#include "tests/support/scenes/picture_files.hpp"

namespace rayclock::test::textures_test {

using namespace rayclock;
using namespace rayclock::test;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string painted_face =
    "mtllib a.mtl\n" + corners + "vt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n";

/// An OBJ file with its MTL file and the picture p.png.
LoadedScene obj(const SceneFolder& folder, const std::string& mtl, const std::string& text = painted_face,
                Textures textures = Textures::drawn) {
    folder.write("p.png", four_texels());
    folder.write("a.mtl", "newmtl a\nKd 0.5 0.5 0.5\n" + mtl);
    return read_scene(folder.write("a.obj", text), textures);
}

std::string obj_complaint(const std::string& text, const std::string& mtl = "map_Kd p.png\n") {
    const SceneFolder folder;
    try {
        obj(folder, mtl, text);
    } catch (const UserError& error) {
        return error.what();
    }
    return {};
}

void check_near(const CornerCoordinates& is, const CornerCoordinates& wanted) {
    for (std::size_t k = 0; k < 3; ++k) {
        INFO(is[k].x << " " << is[k].y << " instead of " << wanted[k].x << " " << wanted[k].y);
        CHECK(glm::length(is[k] - wanted[k]) < 1e-6);
    }
}

/// A glTF file of one triangle with the coordinates (0, 0), (1, 0), (0, 1) as set 0 and (0.5, 0.25)
/// everywhere as set 1.
Json triangle_gltf() {
    std::string bytes;
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) bytes += raw(x);
    for (const float x : {0.f, 0.f, 1.f, 0.f, 0.f, 1.f}) bytes += raw(x);
    for (int i = 0; i < 3; ++i) bytes += raw(0.5f) + raw(0.25f);
    Json json{
        {"asset", {{"version", "2.0"}}},
        {"buffers", {{{"byteLength", bytes.size()}, {"uri", "data:;base64," + base64(bytes)}}}},
        {"images", {{{"uri", "data:image/png;base64," + base64(four_texels())}}}},
        {"textures", {{{"source", 0}}}},
        {"materials",
         {{{"pbrMetallicRoughness",
            {{"baseColorTexture", {{"index", 0}}},
             {"baseColorFactor", {1, 1, 0.5, 1}},
             {"metallicFactor", 0}}}}}},
        {"meshes",
         {{{"primitives",
            {{{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}, {"TEXCOORD_1", 2}}}, {"material", 0}}}}}}},
        {"nodes", {{{"mesh", 0}}}}};
    for (const auto& [offset, length] : {std::pair{0, 36}, {36, 24}, {60, 24}})
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}});
    json["accessors"] = {{{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}},
                         {{"bufferView", 1}, {"componentType", 5126}, {"count", 3}, {"type", "VEC2"}},
                         {{"bufferView", 2}, {"componentType", 5126}, {"count", 3}, {"type", "VEC2"}}};
    return json;
}

Json& base_texture(Json& json) { return json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]; }

LoadedScene gltf(const Json& json, Textures textures = Textures::drawn) {
    const SceneFolder folder;
    return read_scene(folder.write("a.gltf", json.dump()), textures);
}

Json inline_json() {
    return {{"materials", {{"m", {{"colour", {1, 0.5, 1}}, {"texture", "p.png"}}}}},
            {"meshes",
             {{"t",
               {{"vertices", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                {"triangles", {{0, 1, 2}}},
                {"coordinates", {{{0, 1}, {1, 1}, {0, 0}}}}}}}},
            {"objects", {{{"mesh", "t"}, {"material", "m"}}}}};
}

LoadedScene json(const Json& document, Textures textures = Textures::drawn) {
    const SceneFolder folder;
    folder.write("p.png", four_texels());
    folder.write("flat.obj", corners + "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    return read_scene(folder.write("a.json", document.dump()), textures);
}

std::string json_complaint(const Json& document) {
    try {
        json(document);
    } catch (const UserError& error) {
        return error.what();
    }
    return {};
}

using Texels = std::vector<std::array<std::uint8_t, 4>>;

}   // namespace

TEST_CASE("a picture's texels and its average have the same colours in every format") {
    const auto near = [](const glm::vec4& a, const glm::vec4& b) { return glm::length(a - b) < 2e-3f; };
    const Texels codes{{255, 128, 0, 255}, {0, 0, 64, 255}};
    const auto light = [](int code) { return float(std::pow((code / 255.0 + 0.055) / 1.055, 2.4)); };
    for (const std::string& bytes : {small_bmp(), small_tga()}) {
        CHECK(decoded_picture(bytes).texels == codes);
        CHECK(near(average_colour(bytes), {0.5f, light(128) / 2, light(64) / 2, 1}));
    }
    CHECK(decoded_picture(small_tiff(1)).texels == Texels{{64, 191, 255, 128}, {0, 0, 0, 0}});
    CHECK(decoded_picture(small_tiff(2)).texels == Texels{{32, 96, 128, 128}, {0, 0, 0, 0}});
    CHECK(near(average_colour(small_tiff(1)), {light(64) / 2, light(191) / 2, 0.5f, 64 / 255.0f}));
    // Radiance files hold linear light. The code 188 has the intensity 0.503, and 137 has 0.251.
    CHECK(decoded_picture(small_hdr()).texels == Texels{{188, 137, 0, 255}, {0, 0, 0, 255}});
    CHECK(near(average_colour(small_hdr()), {0.25f, 0.125f, 0, 1}));
}

TEST_CASE("json: --no-textures reads every format that is drawn") {
    for (const auto& [name, bytes] : {std::pair{"p.bmp", small_bmp()}, {"p.tga", small_tga()}}) {
        INFO(name);
        const SceneFolder folder;
        folder.write(name, bytes);
        Json document = inline_json();
        document["materials"]["m"]["texture"] = name;
        const std::string file = folder.write("a.json", document.dump());
        CHECK(read_scene(file).scene.textures.size() == 1);
        CHECK(read_scene(file, Textures::averaged).material().colour.r == Approx(0.5).epsilon(1e-3));
    }
}

TEST_CASE("pictures of every depth become codes of 8 bits") {
    const auto bytes = [](std::initializer_list<int> list) {
        std::string text;
        for (const int x : list) text += static_cast<char>(x);
        return text;
    };
    // 16-bit grey: 0x8080 is the code 128.
    CHECK(decoded_picture(png_of(2, 1, 16, 0, bytes({0, 0x80, 0x80, 0xff, 0xff}))).texels ==
          Texels{{128, 128, 128, 255}, {255, 255, 255, 255}});
    CHECK(decoded_picture(png_of(2, 1, 8, 4, bytes({0, 7, 99, 200, 0}))).texels ==
          Texels{{7, 7, 7, 99}, {200, 200, 200, 0}});
    CHECK(decoded_picture(png_of(2, 1, 8, 6, bytes({0, 1, 2, 3, 4, 250, 251, 252, 253}))).texels ==
          Texels{{1, 2, 3, 4}, {250, 251, 252, 253}});
    CHECK(decoded_picture(png_of(3, 1, 1, 0, bytes({0, 0xa0}))).texels ==
          Texels{{255, 255, 255, 255}, {0, 0, 0, 255}, {255, 255, 255, 255}});
    const std::string palette = png_chunk("PLTE", bytes({10, 20, 30, 40, 50, 60}));
    CHECK(decoded_picture(png_of(2, 1, 8, 3, bytes({0, 1, 0}), palette)).texels ==
          Texels{{40, 50, 60, 255}, {10, 20, 30, 255}});
    // The sizes of a header alone.
    const auto refusal = [](std::uint32_t width, std::uint32_t height) -> std::string {
        try {
            decoded_picture(png_of(width, height, 8, 0, std::string(1, '\0')));
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return {};
    };
    CHECK(refusal(16385, 1) == "16385x1 texels are too many");
    CHECK(refusal(1, 16385) == "1x16385 texels are too many");
}

TEST_CASE("obj: map_Kd multiplies the colour, and v increases upwards") {
    const SceneFolder folder;
    const LoadedScene made = obj(folder, "map_Kd p.png\n");
    CHECK(made.notes.empty());
    CHECK(made.material().colour == glm::dvec3(0.5));
    check_near(made.scene.coordinates.at(0), {{{0, 1}, {1, 1}, {0, 0}}});
    const Texture& texture = made.texture();
    CHECK(texture.name == "p.png");
    CHECK(texture.wrap_s == Wrap::repeat);
    REQUIRE(texture.pyramid->levels.size() == 2);
    CHECK(texture.pyramid->levels[0].texels[1] == std::array<std::uint8_t, 4>{255, 0, 0, 255});
    // Without Kd the picture shows its own colours.
    CHECK(obj(folder, "newmtl b\nmap_Kd p.png\n",
              "mtllib a.mtl\n" + corners + "vt 0 0\nusemtl b\nf 1/1 2/1 3/1\n")
              .material()
              .colour == glm::dvec3(1));
}

TEST_CASE("obj: the options of map_Kd and names with blanks are read") {
    const SceneFolder folder;
    const LoadedScene made = obj(folder, "map_Kd -s 2 4 1 -o 0.25 0.5 -clamp on -bm 1 -blendu off p.png\n");
    // s = 2 u + 0.25, t = 1 - (4 v + 0.5)
    check_near(made.scene.coordinates.at(0), {{{0.25, 0.5}, {2.25, 0.5}, {0.25, -3.5}}});
    CHECK(made.texture().wrap_t == Wrap::clamp);
    CHECK(made.notes == Notes{folder.name("a.obj") + ": 2 options of map_Kd ignored (the first: '-bm')"});
    folder.write("my wood.png", four_texels());
    CHECK(obj(folder, "map_Kd -s 1 1 1 my wood.png\n").texture().name == "my wood.png");
    folder.write("sub.png", four_texels());
    CHECK(obj(folder, "map_Kd .\\sub.png\nmap_bump p.png\n").notes ==
          Notes{folder.name("a.obj") + ": 1 material with other textures, which are not drawn ('a')"});
}

TEST_CASE("obj: a missing, foreign or cut picture leaves the material's colour") {
    const SceneFolder folder;
    LoadedScene made = obj(folder, "map_Kd none.png\n");
    CHECK(made.notes == Notes{folder.name("a.obj") + ": a picture is not drawn: " + folder.name("none.png") +
                              ": there is no such file"});
    CHECK(made.material().colour == glm::dvec3(0.5));
    CHECK(made.scene.textures.empty());
    CHECK(made.scene.coordinates.empty());
    folder.write("odd.png", "GIF89a and so on");
    made = obj(folder, "map_Kd odd.png\n");
    REQUIRE(made.notes.size() == 1);
    CHECK_THAT(made.notes[0],
               Contains("a.obj: the picture ") && Contains("odd.png is not drawn: it is not PNG"));
    folder.write("cut.png", four_texels().substr(0, four_texels().size() - 30));
    made = obj(folder, "map_Kd cut.png\n");
    REQUIRE(made.notes.size() == 1);
    CHECK_THAT(made.notes[0], Contains("cut.png is not drawn"));
}

TEST_CASE("obj: faces without coordinates have the average colour") {
    const SceneFolder folder;
    const LoadedScene made = obj(folder, "map_Kd p.png\n", painted_face + "f 1 2 3\nf 1/9 2/2 3/3\n");
    REQUIRE(made.scene.triangles.size() == 3);
    CHECK(made.material(0).texture);
    CHECK_FALSE(made.material(1).texture);
    CHECK(glm::length(made.material(1).colour - glm::dvec3(0.25)) < 1e-12);   // half of half the texels
    CHECK(made.scene.triangles[2].material == made.scene.triangles[1].material);
    CHECK(made.scene.coordinates.size() == 3);
    CHECK(made.notes == Notes{folder.name("a.obj") +
                              ": 2 triangles with a texture and without texture coordinates, drawn in the "
                              "texture's average colour"});
}

TEST_CASE("obj: --no-textures draws the material's colour, and reads no picture") {
    const SceneFolder folder;
    const LoadedScene made = obj(folder, "map_Kd p.png\n", painted_face, Textures::averaged);
    CHECK(made.material().colour == glm::dvec3(0.5));
    CHECK(made.scene.coordinates.empty());
    CHECK(made.notes ==
          Notes{folder.name("a.obj") + ": 1 material with textures, which are not drawn ('a')"});
}

TEST_CASE("obj: coordinates that cannot be drawn are refused where a picture needs them") {
    const auto face = [](const std::string& vt) {
        return "mtllib a.mtl\n" + corners + vt + "usemtl a\nf 1/1 2/2 3/3\n";
    };
    CHECK_THAT(obj_complaint(face("vt 0 0\nvt nan 0\nvt 0 1\n")), Contains("a.obj: line 6: vt 'nan 0'"));
    CHECK_THAT(obj_complaint(face("vt 0 0\nvt 1e9 0\nvt 0 1\n")),
               Contains("a.obj: face 1 has the texture coordinate 1000000000"));
    CHECK_THAT(obj_complaint(face("vt 0 0\nvt 200 0\nvt 0 1\n")), Contains("a.obj: face 1 has texture"));
    CHECK_THAT(obj_complaint(face("vt 0 0\nvt 65 0\nvt 0 1\n"), "map_Kd -clamp on p.png\n"),
               Contains("a.obj: face 1"));
    CHECK(obj_complaint(face("vt 500 0\nvt 501 0\nvt 500 1\n")).empty());
    CHECK(obj_complaint(face("vt 0 0\nvt nan 0\nvt 1e9 1\n"), "").empty());
    CHECK(obj_complaint(face("vt 0 0\nvt nan 0\nvt 0 1\n"), "map_Kd none.png\n").empty());
}

TEST_CASE("glTF: the base colour's texture is drawn with its coordinates and sampler") {
    Json document = triangle_gltf();
    LoadedScene made = gltf(document);
    CHECK(made.notes.empty());
    CHECK(made.material().colour == glm::dvec3(1, 1, 0.5));
    check_near(made.scene.coordinates.at(0), {{{0, 0}, {1, 0}, {0, 1}}});
    CHECK(made.texture().wrap_s == Wrap::repeat);
    CHECK_FALSE(made.texture().nearest);
    CHECK(made.texture().mipmaps);
    document["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9729}}};
    document["textures"][0]["sampler"] = 0;
    base_texture(document)["texCoord"] = 1;
    made = gltf(document);
    CHECK(made.texture().wrap_s == Wrap::clamp);
    CHECK(made.texture().wrap_t == Wrap::mirror);
    CHECK(made.texture().nearest);
    CHECK_FALSE(made.texture().mipmaps);
    check_near(made.scene.coordinates.at(0), {{{0.5, 0.25}, {0.5, 0.25}, {0.5, 0.25}}});
    document["samplers"][0]["wrapS"] = 1;
    CHECK_THROWS_WITH(gltf(document), Contains("samplers[0].wrapS") && Contains("33648"));
}

TEST_CASE("glTF: KHR_texture_transform scales, turns and moves") {
    Json document = triangle_gltf();
    Json& transform = base_texture(document)["extensions"]["KHR_texture_transform"];
    // The example of the extension: the lower left quarter of the picture, turned by a quarter.
    transform = {{"offset", {0, 1}}, {"rotation", std::acos(-1) / 2}, {"scale", {0.5, 0.5}}};
    check_near(gltf(document).scene.coordinates.at(0), {{{0, 1}, {0, 0.5}, {0.5, 1}}});
    transform = {{"rotation", std::acos(-1) / 6}, {"scale", {2, 1}}};
    const double c = std::sqrt(0.75), s = 0.5;
    // (1, 0) becomes (2, 0), then (2 c, -2 s); (0, 1) becomes (s, c). All move by 1 along t.
    check_near(gltf(document).scene.coordinates.at(0), {{{0, 1}, {2 * c, 1 - 2 * s}, {s, c + 1}}});
    transform = {{"texCoord", 1}, {"offset", {0.125, 0}}};
    check_near(gltf(document).scene.coordinates.at(0), {{{0.625, 0.25}, {0.625, 0.25}, {0.625, 0.25}}});
    transform = {{"offset", {1}}};
    CHECK_THROWS_WITH(gltf(document), Contains("offset") && Contains("2 numbers"));
}

TEST_CASE("glTF: wrong coordinates are refused, and missing ones give the average colour") {
    Json document = triangle_gltf();
    document["accessors"][1]["count"] = 2;
    CHECK_THROWS_WITH(gltf(document), Contains("TEXCOORD_0 has 2 texture coordinates for 3 vertices"));
    document = triangle_gltf();
    Json& transform = base_texture(document)["extensions"]["KHR_texture_transform"];
    transform = {{"scale", {1e9, 1}}};
    CHECK_THROWS_WITH(gltf(document), Contains("accessors[1]") && Contains("1e+09"));
    transform = {{"scale", {300, 1}}};
    CHECK_THROWS_WITH(gltf(document), Contains("accessors[1]") && Contains("the most is 64"));
    document = triangle_gltf();
    base_texture(document)["texCoord"] = 2;
    const LoadedScene made = gltf(document);
    CHECK(made.scene.coordinates.empty());
    REQUIRE(made.notes.size() == 1);
    CHECK_THAT(made.notes[0], Contains("1 triangle with a texture and without texture coordinates"));
    CHECK(glm::length(made.material().colour - glm::dvec3(0.5, 0.5, 0.25)) < 1e-12);
}

TEST_CASE("glTF: --no-textures draws the average colour with the old message") {
    const LoadedScene made = gltf(triangle_gltf(), Textures::averaged);
    CHECK(made.scene.textures.empty());
    CHECK(made.scene.coordinates.empty());
    CHECK(glm::length(made.material().colour - glm::dvec3(0.5, 0.5, 0.25)) < 1e-6);
    REQUIRE(made.notes.size() == 1);
    CHECK_THAT(made.notes[0],
               Contains("1 material with a texture of its colour, drawn in the texture's average colour"));
}

TEST_CASE("glTF: instances share the coordinates of their mesh") {
    Json document = triangle_gltf();
    document["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"scale", {-1, 1, 1}}}};
    const LoadedScene made = gltf(document);
    REQUIRE(made.scene.placed);
    CHECK(made.scene.placed->meshes.at(0).coordinates.size() == 1);
    REQUIRE(made.scene.coordinates.size() == 2);
    check_near(made.scene.coordinates[0], {{{0, 0}, {1, 0}, {0, 1}}});
    check_near(made.scene.coordinates[1], {{{0, 0}, {0, 1}, {1, 0}}});
}

TEST_CASE("json: a material's texture is read in short and with all keys") {
    LoadedScene made = json(inline_json());
    CHECK(made.notes.empty());
    CHECK(made.material().colour == glm::dvec3(1, 0.5, 1));
    check_near(made.scene.coordinates.at(0), {{{0, 1}, {1, 1}, {0, 0}}});
    Json document = inline_json();
    document["materials"]["m"]["texture"] = {
        {"file", "p.png"}, {"wrap", {"mirror", "clamp"}}, {"filter", "nearest"}, {"mipmaps", false}};
    made = json(document);
    CHECK(made.texture().wrap_s == Wrap::mirror);
    CHECK(made.texture().wrap_t == Wrap::clamp);
    CHECK(made.texture().nearest);
    CHECK_FALSE(made.texture().mipmaps);
    document["meshes"]["t"] = {{"file", "flat.obj"}};   // keeps its coordinates
    document["objects"][0]["instances"] = {{{"translate", {0, 0, 1}}}, {{"translate", {0, 0, 2}}}};
    made = json(document);
    REQUIRE(made.scene.coordinates.size() == 2);
    check_near(made.scene.coordinates[1], {{{0, 1}, {1, 1}, {0, 0}}});
    const LoadedScene plain = json(inline_json(), Textures::averaged);
    CHECK(plain.scene.coordinates.empty());
    CHECK(glm::length(plain.material().colour - glm::dvec3(0.5, 0.25, 0.5)) < 1e-6);
}

TEST_CASE("json: spheres and planes show their pictures, and meshes without coordinates the average colour") {
    Json document = inline_json();
    document["spheres"] = {{{"centre", {0, 0, 0}}, {"radius", 1}, {"material", "m"}}};
    document["planes"] = {{{"point", {0, 0, 0}}, {"u", {1, 0, 0}}, {"v", {0, 0, 1}}, {"material", "m"}}};
    document["meshes"]["o"] = {{"builtin", "icosphere:1"}};
    document["objects"].push_back({{"mesh", "o"}, {"material", "m"}, {"instances", {Json::object()}}});
    const LoadedScene made = json(document);
    const Scene& scene = made.scene;
    CHECK(scene.materials[scene.triangles[0].material].texture);
    const Material& plain = scene.materials[scene.triangles[1].material];
    CHECK_FALSE(plain.texture);
    CHECK(glm::length(plain.colour - glm::dvec3(0.5, 0.25, 0.5)) < 1e-12);
    CHECK(scene.planes[0].material == scene.triangles[0].material);
    const Material& round = scene.materials[scene.spheres[0].material];
    REQUIRE(round.texture);
    CHECK(scene.textures[*round.texture].wrap_s == Wrap::clamp);
    CHECK(scene.coordinates.size() == 81);
    CHECK(made.notes.size() == 1);
}

namespace {

/// A scene with a sphere and a plane of the material "m", without meshes.
Json round_json(const Json& texture) {
    Json document;
    document["materials"]["m"] = {{"colour", {1, 1, 1}}, {"texture", texture}};
    document["spheres"] = {{{"centre", {0, 0, 0}}, {"radius", 1}, {"material", "m"}}};
    document["planes"] = {{{"point", {0, -1, 0}}, {"u", {1, 0, 0}}, {"v", {0, 0, -1}}, {"material", "m"}}};
    return document;
}
glm::dvec3 colour_at(const Scene& scene, const glm::dvec3& direction) {
    const Texture& texture = scene.textures[*scene.materials[scene.spheres[0].material].texture];
    return filtered(texture, octahedral_place(glm::normalize(direction)), 0);
}

}   // namespace

TEST_CASE("json: the middle of a sphere's picture lies on +z, its top on +y, and s increases towards +x") {
    // Four columns of longitude: black, red, green, blue.
    Json texture{{"pattern", "checker"}, {"size", {256, 128}}, {"columns", 4}, {"rows", 1}};
    texture["colours"] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Json document = round_json(texture);
    Scene scene = json(document).scene;
    CHECK(scene.coordinates.empty());
    CHECK(colour_at(scene, {-0.3, 0.1, -1}) == glm::dvec3(0, 0, 0));   // s from 0 to 1/4
    CHECK(colour_at(scene, {-1, 0.1, 0.3}) == glm::dvec3(1, 0, 0));
    CHECK(colour_at(scene, {0.3, -0.1, 1}) == glm::dvec3(0, 1, 0));
    CHECK(colour_at(scene, {1, 0.1, -0.3}) == glm::dvec3(0, 0, 1));
    document["spheres"][0]["rotate"] = {{"axis", {0, 1, 0}}, {"degrees", 90}};   // +z to +x
    scene = json(document).scene;
    CHECK(colour_at(scene, {1, -0.1, -0.3}) == glm::dvec3(0, 1, 0));
    texture = {{"pattern", "gradient"}, {"size", {4, 64}}, {"colours", {{1, 0, 0}, {0, 0, 1}}}};
    scene = json(round_json(texture)).scene;
    CHECK(colour_at(scene, {0, 1, 0}).r > 0.9);
    CHECK(colour_at(scene, {0, -1, 0}).b > 0.9);
}

TEST_CASE("json: patterns are painted by their formulas") {
    const auto picture = [](const Json& texture) {
        const Scene scene = json(round_json(texture)).scene;
        return scene.textures[*scene.materials[scene.planes[0].material].texture].pyramid->levels[0];
    };
    const auto is = [](const TexelLevel& level, int x, int y, std::array<std::uint8_t, 4> wanted) {
        return level.texels[std::size_t(y * level.width + x)] == wanted;
    };
    const Json two{{1, 1, 1}, {0, 0, 0}};
    const std::array<std::uint8_t, 4> white{255, 255, 255, 255}, black{0, 0, 0, 255};
    TexelLevel level = picture({{"pattern", "checker"}, {"size", 8}, {"colours", two}});
    CHECK((level.width == 8 && level.height == 8));
    CHECK((is(level, 0, 0, white) && is(level, 4, 3, black) && is(level, 3, 4, black) &&
           is(level, 7, 7, white)));
    level = picture({{"pattern", "bricks"},
                     {"size", 64},
                     {"columns", 2},
                     {"rows", 4},
                     {"joint", 0.25},
                     {"colours", two}});
    CHECK((is(level, 20, 3, black) && is(level, 20, 4, white)));    // a joint of 4 rows of texels
    CHECK((is(level, 3, 8, black) && is(level, 4, 8, white)));      // and of 4 columns
    CHECK((is(level, 3, 24, white) && is(level, 16, 24, black)));   // the next row is shifted by half a brick
    level = picture({{"pattern", "gradient"}, {"size", {1, 4}}, {"colours", two}});
    for (int y = 0; y < 4; ++y) {
        const std::uint8_t code = linear_to_srgb(1 - (y + 0.5) / 4);
        CHECK(is(level, 0, y, {code, code, code, 255}));
    }
    const Json noise{{"pattern", "noise"}, {"size", 32}, {"colours", two}, {"seed", 5}};
    level = picture(noise);
    CHECK(level.texels == picture(noise).texels);
    Json other = noise;
    other["seed"] = 6;
    CHECK(level.texels != picture(other).texels);
    CHECK(std::ranges::count(level.texels, white) >= 1);   // stretched to both ends
    CHECK(std::ranges::count(level.texels, black) >= 1);
    // No seam. One octave has its random values in every 16th column, so neighbouring columns differ little.
    // The first and the last column differ no more than neighbouring columns do. The same holds for rows.
    other = noise;
    other["size"] = 64, other["columns"] = 4, other["rows"] = 4, other["octaves"] = 1;
    level = picture(other);
    const auto step = [&](int at, int across, int down) {
        int most = 0;
        for (int i = 0; i < 64; ++i) {
            const auto code = [&](int k) {
                return int(level.texels[std::size_t(across * (k % 64) + down * i)][0]);
            };
            most = std::max(most, std::abs(code(at) - code(at + 1)));
        }
        return most;
    };
    for (const auto& [across, down] : {std::pair(1, 64), std::pair(64, 1)}) {
        int most_inside = 0;
        for (int at = 0; at < 63; ++at) most_inside = std::max(most_inside, step(at, across, down));
        CHECK(step(63, across, down) <= most_inside);
    }
}

TEST_CASE("json: a pattern with a fault is refused in one sentence") {
    const auto refused = [](const Json& texture, const char* sentence) {
        CHECK_THROWS_WITH(json(round_json(texture)), Contains(sentence));
    };
    refused({{"pattern", "stripes"}}, "must be \"checker\", \"bricks\", \"gradient\" or \"noise\"");
    refused({{"pattern", "checker"}, {"file", "p.png"}}, "has both 'file' and 'pattern'");
    refused({{"pattern", "checker"}, {"size", 100}}, "must be a power of two from 1 to 4096, not 100");
    refused({{"pattern", "checker"}, {"joint", 0.1}}, "joint");
    refused({{"pattern", "bricks"}, {"colours", {{1, 1, 1}}}}, "must be a list of 2 colours");
    refused({{"pattern", "noise"}, {"octaves", 9}}, "must be a whole number from 1 to 8, not 9");
    refused({{"pattern", "noise"}, {"octaves", 8}, {"columns", 33}}, "from 1 to 32");
    Json document = round_json({{"pattern", "checker"}});
    document["planes"][0]["coordinates"] = {{0, 0}, {1e7, 0}, {0, 1}};
    CHECK_THROWS_WITH(json(document), Contains("must be within -1000000 and 1000000"));
    document["planes"][0]["coordinates"] = {{0, 0}, {2, 0}};
    CHECK_THROWS_WITH(json(document), Contains("must be 3 points [s, t], at point, point + u and point + v"));
}

TEST_CASE("json: the random values of noise count as memory that a file makes") {
    Json document = round_json({{"pattern", "checker"}});
    for (int i = 0; i < 40; ++i)
        document["materials"]["n" + std::to_string(i)]["texture"] = {
            {"pattern", "noise"}, {"size", 1}, {"columns", 4096}, {"rows", 4096}, {"octaves", 1}};
    CHECK_THROWS_WITH(json(document), Contains("makes more than"));
}

TEST_CASE("json: spheres and planes have no holes, and a warning says so") {
    Json document = round_json({{"pattern", "checker"}});
    document["materials"]["m"]["cutoff"] = 0.5;
    const LoadedScene made = json(document);
    REQUIRE(made.notes.size() == 2);
    CHECK_THAT(made.notes[0], Contains("without holes"));
}

TEST_CASE("json: the room as a mesh keeps its textures, in their own numbering") {
    Json document = inline_json();
    document["meshes"]["room"] = {{"builtin", "room"}};
    document["objects"].push_back({{"mesh", "room"}});
    const LoadedScene made = json(document);
    CHECK(made.scene.textures.size() == 7);
    CHECK(made.texture(0).name == "p.png");
    CHECK(made.texture(1).name == "tiles");
    const Scene room = load_scene("room", {}, Primitives::triangles, nullptr, Textures::averaged);
    CHECK(room.textures.empty());
    CHECK(room.coordinates.empty());
}

TEST_CASE("json: wrong textures are named by their path") {
    const auto with = [](const Json& texture) {
        Json document = inline_json();
        document["materials"]["m"]["texture"] = texture;
        return json_complaint(document);
    };
    CHECK_THAT(with("none.png"),
               Contains("none.png: there is no such file") && Contains("materials.m.texture"));
    CHECK_THAT(with("flat.obj"), Contains("materials.m.texture names 'flat.obj'") && Contains("not PNG"));
    CHECK_THAT(with(3), Contains("materials.m.texture must be the name of a picture"));
    CHECK_THAT(with({{"file", "p.png"}, {"wrap", "round"}}), Contains("materials.m.texture.wrap"));
    CHECK_THAT(with({{"file", "p.png"}, {"filter", "cubic"}}), Contains("\"nearest\" or \"bilinear\""));
    CHECK_THAT(with({{"file", "p.png"}, {"mip", true}}), Contains("'mip'"));
    Json document = inline_json();
    document["materials"]["m"].erase("texture"), document["materials"]["m"]["cutoff"] = 0.5;
    CHECK_THAT(json_complaint(document), Contains("materials.m.cutoff") && Contains("has no texture"));
    document = inline_json();
    document["meshes"]["t"]["coordinates"] = Json::array();
    CHECK_THAT(json_complaint(document), Contains("coordinates has 0 entries for 1 triangles"));
    document["meshes"]["t"]["coordinates"] = {{{0, 0}, {1000, 0}, {0, 1}}};
    CHECK_THAT(json_complaint(document), Contains("triangle 0 (counted from 0) has texture coordinates"));
    document["meshes"]["t"]["coordinates"] = {{{0, 0}, {1e9, 0}, {0, 1}}};
    CHECK_THAT(json_complaint(document), Contains("1e+09"));
}

TEST_CASE("pictures of odd sizes are resampled, with a note if they shrink") {
    const SceneFolder folder;
    folder.write("p3.png", png_bytes({{3, 5}, std::vector<glm::vec3>(15, glm::vec3(1))}));
    const LoadedScene made = obj(folder, "map_Kd p3.png\n");
    CHECK(made.notes.empty());
    CHECK(made.texture().pyramid->levels[0].width == 4);
    CHECK(made.texture().pyramid->levels[0].height == 4);
    folder.write("wide.png", png_bytes({{5000, 1}, std::vector<glm::vec3>(5000, glm::vec3(1))}));
    const LoadedScene wide = obj(folder, "map_Kd wide.png\n");
    REQUIRE(wide.notes.size() == 1);
    CHECK_THAT(wide.notes[0], Contains("wide.png has 5000 x 1 texels, drawn with 4096 x 1"));
}

}   // namespace rayclock::test::textures_test
