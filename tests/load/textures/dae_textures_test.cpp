// Pictures of COLLADA: the path from a material to its picture, samplers, and the choice of coordinates. The
// expected values follow from the standard's text.
#include <catch2/catch.hpp>

#include "tests/load/textures/textured_scenes.hpp"

namespace rayclock::test::dae_textures_test {

using namespace rayclock;
using namespace rayclock::test;
using Catch::Contains;

namespace {

/// The parts of a document. Its mesh is the square with the corners (0, 0) to (1, 1) and has two sets of
/// coordinates: the corner's place, and a quarter of this place.
struct Document {
    std::string images = "<image id=\"i\"><init_from>p.png</init_from></image>";
    std::string sampler = "<sampler2D><source>surface</source></sampler2D>";
    std::string params =
        "<newparam sid=\"surface\"><surface type=\"2D\"><init_from>i</init_from></surface>"
        "</newparam>";
    std::string shader =
        "<lambert><diffuse><texture texture=\"sampler\" texcoord=\"UV\"/></diffuse></lambert>";
    std::string set0 = "0 0 1 0 1 1 0 1", set1 = "0 0 0.25 0 0.25 0.25 0 0.25";
    std::string inputs =
        "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
        "<input semantic=\"TEXCOORD\" source=\"#t0\" offset=\"1\" set=\"0\"/>"
        "<input semantic=\"TEXCOORD\" source=\"#t1\" offset=\"1\" set=\"1\"/>";
    std::string primitive = "triangles", lists = "<p>0 0 1 1 2 2 0 0 2 2 3 3</p>", per_vertex, in_mesh;
    std::string bind = "<bind_vertex_input semantic=\"UV\" input_semantic=\"TEXCOORD\" input_set=\"0\"/>";

    static std::string source(const std::string& id, const std::string& numbers, int stride,
                              const std::string& params) {
        return "<source id=\"" + id + "\"><float_array id=\"" + id + "a\">" + numbers +
               "</float_array><technique_common><accessor source=\"#" + id + "a\" count=\"4\" stride=\"" +
               std::to_string(stride) + "\">" + params + "</accessor></technique_common></source>\n";
    }
    static std::string instance(const std::string& bind) {
        return "<instance_geometry url=\"#g\"><bind_material><technique_common><instance_material "
               "symbol=\"s\" target=\"#m\">" +
               bind + "</instance_material></technique_common></bind_material></instance_geometry>";
    }
    std::string text(const std::string& more_nodes = {}) const {
        const std::string st = R"(<param name="S"/><param name="T"/>)";
        return "<COLLADA><asset><up_axis>Y_UP</up_axis></asset><library_images>" + images +
               "</library_images>\n<library_effects><effect id=\"e\"><profile_COMMON>" + params +
               "<newparam sid=\"sampler\">" + sampler + "</newparam>\n<technique>" + shader +
               "</technique></profile_COMMON></effect></library_effects><library_materials><material "
               "id=\"m\"><instance_effect url=\"#e\"/></material></library_materials>\n<library_geometries>"
               "<geometry id=\"g\"><mesh>" +
               source("p", "0 0 0 1 0 0 1 1 0 0 1 0", 3, "") + source("t0", set0, 2, st) +
               source("t1", set1, 2, st) + in_mesh +
               "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/>" + per_vertex +
               "</vertices>\n<" + primitive + " material=\"s\">" + inputs + "\n" + lists + "</" + primitive +
               "></mesh></geometry></library_geometries><library_visual_scenes><visual_scene "
               "id=\"V\"><node>" +
               instance(bind) + more_nodes +
               "</node></visual_scene></library_visual_scenes><scene><instance_visual_scene "
               "url=\"#V\"/></scene></COLLADA>";
    }
};

LoadedScene read_text(const SceneFolder& folder, const std::string& text,
                      Textures textures = Textures::drawn) {
    folder.write("p.png", four_texels());
    return read_scene(folder.write("a.dae", text), textures);
}
LoadedScene read(const Document& document, Textures textures = Textures::drawn) {
    const SceneFolder folder;
    return read_text(folder, document.text(), textures);
}
std::string refusal(const Document& document) { return refusal_of("a.dae", document.text()); }

}   // namespace

TEST_CASE("dae: a picture by its sampler and surface replaces the diffuse colour, and t increases upwards") {
    const LoadedScene made = read({});
    CHECK(made.notes.empty());
    CHECK(made.material().colour == glm::dvec3(1));
    check_coordinates(made.scene);
    const Texture& texture = made.texture();
    CHECK(texture.name == "p.png");
    CHECK((texture.wrap_s == Wrap::repeat && texture.wrap_t == Wrap::repeat));
    CHECK_FALSE(texture.nearest);
    CHECK(texture.mipmaps);
    CHECK(texture.pyramid->levels[0].texels[1] == std::array<std::uint8_t, 4>{255, 0, 0, 255});
}

TEST_CASE("dae: a picture is found without a surface, as in 1.5, and if the texture names it") {
    Document document;
    document.params.clear();
    document.images = "<image id=\"i\"><init_from><ref>./p.png</ref></init_from></image>";
    document.sampler = "<sampler2D><instance_image url=\"#i\"/></sampler2D>";
    CHECK(read(document).texture().name == "./p.png");
    document.shader = "<phong><diffuse><texture texture=\"i\" texcoord=\"UV\"/></diffuse></phong>";
    CHECK(read(document).texture().name == "./p.png");
    document = {};
    document.shader = "<phong><diffuse><texture texture=\"surface\" texcoord=\"UV\"/></diffuse></phong>";
    CHECK(read(document).texture().name == "p.png");
}

TEST_CASE("dae: names of pictures are URIs, and absolute names mean files next to the document") {
    Document document;
    const SceneFolder folder;
    folder.write("my wood.png", four_texels());
    for (const char* name :
         {"my%20wood.png", "file:///home/me/my%20wood.png", "file://C:/Users/me/my wood.png",
          "C:\\Users\\me\\my wood.png", "/home/me/MY WOOD.PNG", "File:my%20wood.png"}) {
        INFO(name);
        document.images = "<image id=\"i\"><init_from>\n" + std::string(name) + " </init_from></image>";
        const LoadedScene made = read_text(folder, document.text());
        CHECK(made.notes.empty());
        CHECK(made.material().texture);
    }
    std::filesystem::create_directory(folder.name("in"));
    document.images = "<image id=\"i\"><init_from>../p.png</init_from></image>";
    Notes notes;
    load_scene(folder.write("in/a.dae", document.text()), {}, Primitives::triangles, &notes);
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], Contains("p.png lies outside the folder of the document"));
}

TEST_CASE("dae: the sampler sets wrap modes and filters") {
    Document document;
    const auto sampled = [&](const std::string& keys) {
        document.sampler = "<sampler2D><source>surface</source>" + keys + "</sampler2D>";
        return read(document);
    };
    LoadedScene made = sampled("<wrap_s>CLAMP</wrap_s><wrap_t>MIRROR</wrap_t><magfilter>NEAREST</magfilter>");
    CHECK((made.texture().wrap_s == Wrap::clamp && made.texture().wrap_t == Wrap::mirror));
    CHECK(made.texture().nearest);
    CHECK(made.texture().mipmaps);
    CHECK(made.notes.empty());
    for (const auto& [filters, has_levels] :
         {std::pair("<minfilter>LINEAR</minfilter>", false),
          {"<minfilter>NEAREST</minfilter>", false},
          {"<minfilter>LINEAR_MIPMAP_NEAREST</minfilter>", true},
          {"<minfilter>NONE</minfilter>", true},
          {"<minfilter>LINEAR</minfilter><mipfilter>LINEAR</mipfilter>", true},
          {"<minfilter>ANISOTROPIC</minfilter><mipfilter>NONE</mipfilter>", false}}) {
        INFO(filters);
        CHECK(sampled(filters).texture().mipmaps == has_levels);
    }
    made = sampled("<wrap_s>BORDER</wrap_s><wrap_t>NONE</wrap_t>");
    CHECK((made.texture().wrap_s == Wrap::clamp && made.texture().wrap_t == Wrap::clamp));
    REQUIRE(made.notes.size() == 1);
    CHECK_THAT(made.notes[0], Contains("2 samplers with a border") && Contains("the first: line 2"));
    document.sampler = "<sampler2D><source>surface</source>\n<wrap_s>TWICE</wrap_s></sampler2D>";
    CHECK_THAT(refusal(document), Contains("a.dae: line 3: wrap_s is 'TWICE'") && Contains("MIRROR"));
    document.sampler = "<sampler2D><source>surface</source><minfilter>BEST</minfilter></sampler2D>";
    CHECK_THAT(refusal(document), Contains("a.dae: line 2: minfilter is 'BEST'"));
}

TEST_CASE("dae: bind_vertex_input chooses the set of coordinates") {
    Document document;
    document.bind =
        "<bind_vertex_input semantic=\"OTHER\" input_semantic=\"TEXCOORD\" input_set=\"0\"/>"
        "<bind_vertex_input semantic=\"UV\" input_semantic=\"TEXCOORD\" input_set=\"1\"/>";
    check_coordinates(read(document).scene, {0.25, 0.25});
    // Without a number it is the set 0.
    document.bind = "<bind_vertex_input semantic=\"UV\" input_semantic=\"TEXCOORD\"/>";
    check_coordinates(read(document).scene);
    document.bind.clear();
    LoadedScene made = read(document);
    check_coordinates(made.scene);
    REQUIRE(made.notes.size() == 1);
    CHECK_THAT(made.notes[0], Contains("1 primitive with several sets of texture coordinates"));
    document.inputs =
        "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
        "<input semantic=\"TEXCOORD\" source=\"#t1\" offset=\"1\" set=\"3\"/>";
    made = read(document);
    CHECK(made.notes.empty());
    check_coordinates(made.scene, {0.25, 0.25});
}

TEST_CASE("dae: two copies of a mesh can show different sets of coordinates") {
    const SceneFolder folder;
    const LoadedScene made = read_text(
        folder,
        Document{}.text(Document::instance("<bind_vertex_input semantic=\"UV\" input_semantic=\"TEXCOORD\" "
                                           "input_set=\"1\"/>") +
                        Document::instance("<bind_vertex_input semantic=\"UV\" input_semantic=\"TEXCOORD\" "
                                           "input_set=\"0\"/>")));
    REQUIRE(made.scene.coordinates.size() == 6);
    CHECK(made.scene.coordinates[0] == made.scene.coordinates[4]);
    CHECK(made.scene.coordinates[2][1] == glm::dvec2(0.25, 1));
    CHECK(made.scene.textures.size() == 1);
}

TEST_CASE("dae: coordinates are read from polygons, strips, fans, vertices, and sources with other strides") {
    Document document;
    const auto check = [&](const std::string& primitive, const std::string& lists, std::size_t triangles) {
        INFO(primitive);
        document.primitive = primitive, document.lists = lists;
        const LoadedScene made = read(document);
        CHECK(made.scene.triangles.size() == triangles);
        CHECK(made.notes.empty());
        check_coordinates(made.scene);
    };
    check("polylist", "<vcount>4 3</vcount><p>0 0 1 1 2 2 3 3 0 0 1 1 2 2</p>", 3);
    check("polygons", "<p>0 0 1 1 2 2 3 3</p>", 2);
    check("tristrips", "<p>0 0 1 1 3 3 2 2</p>", 2);
    check("trifans", "<p>0 0 1 1 2 2 3 3</p>", 2);
    // Coordinates have their own indices, at any offset.
    document.inputs =
        "<input semantic=\"TEXCOORD\" source=\"#t0\" offset=\"0\"/>"
        "<input semantic=\"VERTEX\" source=\"#v\" offset=\"2\"/>";
    document.set0 = "1 1 0 1 0 0 1 0";
    check("triangles", "<p>2 9 0 3 9 1 0 9 2</p>", 1);
    document = {};
    document.per_vertex = "<input semantic=\"TEXCOORD\" source=\"#t0\"/>";
    document.inputs = "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>";
    check("triangles", "<p>0 1 2 0 2 3</p>", 2);
    document = {};
    document.inputs =
        "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
        "<input semantic=\"TEXCOORD\" source=\"#w\" offset=\"0\"/>";
    document.in_mesh =
        Document::source("w", "9 0 0 9 1 0 9 1 1 9 0 1", 3, R"(<param/><param name="S"/><param name="T"/>)");
    check("triangles", "<p>0 1 2 0 2 3</p>", 2);
}

TEST_CASE("dae: without coordinates, or with a missing set, the average colour is drawn") {
    Document document;
    document.bind = "<bind_vertex_input semantic=\"UV\" input_semantic=\"TEXCOORD\" input_set=\"7\"/>";
    for (int i = 0; i < 2; ++i) {
        const LoadedScene made = read(document);
        CHECK_FALSE(made.material().texture);
        CHECK(made.scene.coordinates.empty());
        CHECK(glm::length(made.material().colour - glm::dvec3(0.5)) < 1e-12);
        REQUIRE(made.notes.size() == 1);
        CHECK_THAT(made.notes[0], Contains("2 triangles with a texture and without texture coordinates"));
        document.inputs =
            "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
            "<input semantic=\"NORMAL\" source=\"#p\" offset=\"1\"/>";
    }
}

TEST_CASE("dae: --no-textures draws the average colour") {
    const LoadedScene made = read({}, Textures::averaged);
    CHECK(made.scene.textures.empty());
    CHECK(made.scene.coordinates.empty());
    CHECK(glm::length(made.material().colour - glm::dvec3(0.5)) < 1e-6);
    REQUIRE(made.notes.size() == 1);
    CHECK_THAT(made.notes[0],
               Contains("1 material with a texture of its colour, drawn in the texture's average colour"));
}

TEST_CASE("dae: a picture that is missing or cut off leaves a grey surface and one sentence") {
    const SceneFolder folder;
    Document document;
    document.images = "<image id=\"i\"><init_from>none.png</init_from></image>";
    LoadedScene made = read_text(folder, document.text());
    CHECK(made.notes == Notes{folder.name("a.dae") + ": a picture is not drawn: " + folder.name("none.png") +
                              ": there is no such file"});
    CHECK(glm::length(made.material().colour - glm::dvec3(0.8)) < 1e-6);
    CHECK(made.scene.textures.empty());
    CHECK(read_text(folder, document.text(), Textures::averaged).notes == made.notes);
    folder.write("cut.png", four_texels().substr(0, 60));
    document.images = "<image id=\"i\"><init_from>cut.png</init_from></image>";
    made = read_text(folder, document.text());
    REQUIRE(made.notes.size() == 1);
    CHECK_THAT(made.notes[0], Contains("a.dae: the picture ") && Contains("cut.png is not drawn: "));
    for (const char* images : {"", "<image id=\"i\"><data>00ff</data></image>"}) {
        document.images = images;
        made = read_text(folder, document.text());
        REQUIRE(made.notes.size() == 1);
        CHECK_THAT(made.notes[0], Contains("a.dae: 1 ") && Contains("not drawn") && Contains("line "));
    }
}

TEST_CASE("dae: wrong coordinates are refused with their line, if a picture needs them") {
    const std::string missing = "<image id=\"i\"><init_from>none.png</init_from></image>";
    struct Case {
        std::function<void(Document&)> change;
        std::string sentence;
    };
    const std::vector<Case> cases{
        {[](Document& d) { d.set0 = "0 0 1 0 nan 1 0 1"; }, "line 9: texture coordinate 2 has the value nan"},
        {[](Document& d) { d.set0 = "0 0 1 0 1 1 0 1e9"; },
         "line 9: texture coordinate 3 has the value 1000000000; the most is 1000000"},
        {[](Document& d) { d.set0 = "0 0 1 0 1 1"; }, "line 5: 4 points go beyond the 6 numbers"},
        {[](Document& d) { d.lists = "<p>0 0 1 1 2 4</p>"; },
         "line 9: texture coordinate index 4 is out of range: there are 4 (0 is the first)"},
        {[](Document& d) {
             d.inputs =
                 "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
                 "<input semantic=\"TEXCOORD\" source=\"#t9\" offset=\"1\"/>";
         },
         "line 8: input names '#t9', which is not in the file"}};
    for (const Case& each : cases) {
        INFO(each.sentence);
        Document document;
        each.change(document);
        CHECK_THAT(refusal(document), Contains("a.dae: " + each.sentence));
        document.images = missing;
        CHECK(refusal(document).empty());
    }
    Document document;
    document.set0 = "0 0 200 0 1 1 0 1";
    CHECK_THAT(refusal(document), Contains("a.dae: triangle 0 (counted from 0) has texture coordinates") &&
                                      Contains("the most is 64"));
    document.set0 = "500 0 501 0 501 1 500 1";
    CHECK(refusal(document).empty());
}

TEST_CASE("dae: every changed byte of a file with a picture loads or is refused") {
    const SceneFolder folder;
    folder.write("p.png", four_texels());
    const std::string sound = Document{}.text();
    std::size_t drawn = 0, refused = 0;
    for (std::size_t i = 0; i < sound.size(); i += 3) {
        std::string changed = sound;
        changed[i] = char(changed[i] ^ (1 << (i % 7)));
        const std::string said = complaint(folder.write("a.dae", changed));
        refused += !said.empty(), drawn += said.empty();
        REQUIRE(said.find('\n') == said.npos);
    }
    CHECK(drawn > 100);
    CHECK(refused > 100);
}

TEST_CASE("dae: other textures are left out with a note") {
    Document document;
    document.shader =
        "<phong><diffuse><texture texture=\"sampler\" texcoord=\"UV\"/></diffuse><transparent>"
        "<texture texture=\"sampler\" texcoord=\"UV\"/></transparent></phong>";
    const LoadedScene made = read(document);
    CHECK(made.material().texture);
    CHECK(made.material().transmit == 0);
    REQUIRE(made.notes.size() == 1);
    CHECK_THAT(made.notes[0], Contains("1 material with other textures, which are not drawn"));
}

}   // namespace rayclock::test::dae_textures_test
