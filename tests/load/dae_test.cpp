// COLLADA by its standard: the effect of each element on the triangles and colours of one small mesh. The
// expected values follow from the standard's text; each case maps points.
#include <catch2/catch.hpp>

#include <functional>

#include <glm/geometric.hpp>

#include "tests/support/scenes/scene_files.hpp"

using namespace rayclock;
using namespace rayclock::test;
using Catch::Contains;

namespace {

using Point = glm::dvec3;
using Map = std::function<Point(const Point&)>;

const std::vector<Point> points{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 0.5}};
const std::string corners = "0 0 0 2 0 0 0 1 0 0 0 0.5",
                  input = R"(<input semantic="VERTEX" source="#v" offset="0"/>)";
const std::string params = R"(<param name="X"/><param name="Y"/><param name="Z"/>)";

std::string source(const std::string& id, const std::string& numbers, int count, int stride,
                   const std::string& params) {
    return "<source id=\"" + id + "\"><float_array id=\"" + id + "a\">" + numbers +
           "</float_array><technique_common><accessor source=\"#" + id + "a\" count=\"" +
           std::to_string(count) + "\" stride=\"" + std::to_string(stride) + "\">" + params +
           "</accessor></technique_common></source>";
}
std::string mesh_of(const std::string& sources, const std::string& primitives) {
    return "<geometry id=\"g\"><mesh>" + sources +
           "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>" + primitives +
           "</mesh></geometry>";
}
std::string mesh(const std::string& primitives) {
    return mesh_of(source("p", corners, 4, 3, params), primitives);
}
const std::string plain = "<triangles material=\"s\">" + input + "<p>0 2 1 0 1 3</p></triangles>";
const std::vector<std::array<int, 3>> plain_faces{{0, 2, 1}, {0, 1, 3}};
const std::string instance = R"(<instance_geometry url="#g"/>)", here = "<node>" + instance + "</node>";

std::string document(const std::string& nodes, const std::string& geometries = mesh(plain),
                     const std::string& libraries = {},
                     const std::string& asset = "<up_axis>Y_UP</up_axis>") {
    return "<COLLADA><asset>" + asset + "</asset>" + libraries + "<library_geometries>" + geometries +
           "</library_geometries><library_visual_scenes><visual_scene id=\"V\">" + nodes +
           "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
           "url=\"#V\"/></scene></COLLADA>";
}

struct Told {
    Scene scene;
    std::string notes;
};
Told load(const std::string& text) {
    const SceneFolder folder;
    Told told;
    std::vector<std::string> notes;
    told.scene = load_scene(folder.write("a.dae", text), {}, Primitives::triangles, &notes);
    for (const std::string& note : notes) told.notes += note + "\n";
    return told;
}

/// Requires the faces of the mesh, once for each map, in this order.
void check(const std::string& text, const std::vector<Map>& maps,
           const std::vector<std::array<int, 3>>& faces = plain_faces) {
    INFO(text);
    const std::vector<Corners> made = corners_of(load(text).scene);
    REQUIRE(made.size() == maps.size() * faces.size());
    for (std::size_t t = 0; t < made.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const Point right = maps[t / faces.size()](points[faces[t % faces.size()][k]]);
            CAPTURE(t, k);
            CHECK(glm::length(made[t][k] - right) < 1e-6);
        }
}
Point same(const Point& p) { return p; }
Map moved(double x, double y, double z) {
    return [=](const Point& p) { return p + Point(x, y, z); };
}

std::string drawn_with(const std::string& shader, const std::string& in_profile = {},
                       const std::string& in_effect = {}, const std::string& in_instance = {},
                       const std::string& tool = {}) {
    return document(
        "<node><instance_geometry url=\"#g\"><bind_material><technique_common><instance_material "
        "symbol=\"s\" target=\"#m\"/></technique_common></bind_material></instance_geometry></node>",
        mesh(plain),
        "<library_effects><effect id=\"e\">" + in_effect + "<profile_COMMON>" + in_profile + "<technique>" +
            shader + "</technique></profile_COMMON></effect></library_effects>" +
            "<library_materials><material id=\"m\"><instance_effect url=\"#e\">" + in_instance +
            "</instance_effect></material></library_materials>",
        "<contributor><authoring_tool>" + tool + "</authoring_tool></contributor>");
}
Material material(const std::string& text) { return load(text).scene.materials.at(0); }
constexpr const char* red = "<diffuse><color>1 0 0 1</color></diffuse>";

/// Returns the transmission of a red surface with this <transparent> and <transparency>.
double transmitted(const std::string& mode, const std::string& colour, const std::string& strength,
                   const std::string& tool = {}) {
    const std::string transparent =
        colour.empty() ? "" : "<transparent " + mode + "><color>" + colour + "</color></transparent>";
    const std::string transparency =
        strength.empty() ? "" : "<transparency><float>" + strength + "</float></transparency>";
    return material(drawn_with("<lambert>" + std::string(red) + transparent + transparency + "</lambert>", {},
                               {}, {}, tool))
        .transmit;
}

std::string node(const std::string& transform) { return "<node>" + transform + instance + "</node>"; }

const std::string one = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
std::string skin(const std::string& shape, const std::string& bound, const std::string& weights) {
    return "<library_controllers><controller id=\"c\"><skin source=\"#g\"><bind_shape_matrix>" + shape +
           "</bind_shape_matrix><source id=\"j\"><Name_array id=\"ja\">J K</Name_array><technique_common>"
           "<accessor source=\"#ja\" count=\"2\"/></technique_common></source>" +
           source("b", bound + " " + one, 2, 16, "") + source("w", weights, 2, 1, "") +
           "<joints><input semantic=\"JOINT\" source=\"#j\"/><input semantic=\"INV_BIND_MATRIX\" "
           "source=\"#b\"/></joints><vertex_weights count=\"4\"><input semantic=\"JOINT\" source=\"#j\" "
           "offset=\"0\"/><input semantic=\"WEIGHT\" source=\"#w\" offset=\"1\"/><vcount>2 2 2 2</vcount>"
           "<v>0 0 1 1 0 0 1 1 0 0 1 1 0 0 1 "
           "1</v></vertex_weights></skin></controller></library_controllers>";
}
const std::string skinned =
    "<node id=\"J\" sid=\"J\"><translate>4 0 0</translate></node><node id=\"other\" sid=\"K\"><translate>0 8 "
    "0</translate></node><node><translate>50 0 0</translate><instance_controller "
    "url=\"#c\"><skeleton>#J</skeleton>"
    "</instance_controller></node>";

std::string morph(const std::string& weight, const std::string& method) {
    return "<library_controllers><controller id=\"c\"><morph source=\"#g\" method=\"" + method +
           "\"><source id=\"t\"><IDREF_array id=\"ta\">h</IDREF_array><technique_common><accessor "
           "source=\"#ta\" count=\"1\"/></technique_common></source>" +
           source("w", weight, 1, 1, "") +
           "<targets><input semantic=\"MORPH_TARGET\" source=\"#t\"/><input semantic=\"MORPH_WEIGHT\" "
           "source=\"#w\"/></targets></morph></controller></library_controllers>";
}
const std::string target =
    "<geometry id=\"h\"><mesh>" + source("q", "0 4 0 2 4 0 0 5 0 0 4 0.5", 4, 3, params) +
    "<vertices id=\"u\"><input semantic=\"POSITION\" source=\"#q\"/></vertices></mesh></geometry>";

}   // namespace

TEST_CASE("dae: a node's transforms are applied in their order, lookat and skew among them") {
    check(document(node("<translate>4 0 0</translate><rotate>0 0 1 90</rotate><scale>2 1 1</scale>")),
          {[](const Point& p) { return Point(4 - p.y, 2 * p.x, p.z); }});
    check(document(node("<matrix>0 -1 0 4 2 0 0 0 0 0 1 0 0 0 0 1</matrix>")),
          {[](const Point& p) { return Point(4 - p.y, 2 * p.x, p.z); }});
    // Looks along +x from (1, 2, 3): its -z is +x, its y stays, its x is +z. "Up" need not be perpendicular.
    for (const char* up : {"0 1 0", "3 4 0"})
        check(document(node("<lookat>1 2 3 5 2 3 " + std::string(up) + "</lookat>")),
              {[](const Point& p) { return Point(1 - p.z, 2 + p.y, 3 + p.x); }});
    // RenderMan's: points move along x, so that the y axis turns towards x by 45 degrees.
    check(document(node("<skew>45 0 1 0 1 0 0</skew>")),
          {[](const Point& p) { return Point(p.x + p.y, p.y, p.z); }});
    // Points on (1, 1, 0) turn away from x by 45 degrees, onto the y axis: x falls by y.
    check(document(node("<skew>-45 1 1 0 1 0 0</skew>")),
          {[](const Point& p) { return Point(p.x - p.y, p.y, p.z); }});
    const SceneFolder folder;
    CHECK_THAT(complaint(folder.write("a.dae", document(node("<lookat>1 2 3 1 2 3 0 1 0</lookat>")))),
               Contains("lookat") && Contains("one line"));
}

TEST_CASE("dae: each part has the axes and the unit of its own asset") {
    const auto up = [](const char* axis) { return "<up_axis>" + std::string(axis) + "</up_axis>"; };
    check(document(here, mesh(plain), {}, up("Z_UP")),
          {[](const Point& p) { return Point(p.x, p.z, -p.y); }});
    check(document(here, mesh(plain), {}, up("X_UP")),
          {[](const Point& p) { return Point(-p.y, p.x, p.z); }});
    // The document's unit scales everything equally and is ignored. A node's unit applies to its own
    // transforms, and a geometry's to its own points.
    const std::string half = "<asset><unit meter=\"0.5\"/></asset>", whole = "<unit meter=\"1\"/>";
    check(document(here, mesh(plain), {}, "<unit meter=\"0.0254\"/>"), {same});
    check(document("<node>" + half + "<translate>8 0 0</translate>" + instance + "</node>", mesh(plain), {},
                   whole),
          {moved(4, 0, 0)});
    std::string small = mesh(plain);
    small.insert(small.find("<mesh>"), half);
    check(document(here, small, {}, whole), {[](const Point& p) { return 0.5 * p; }});
    CHECK_THAT(load(document(here, small, {}, whole)).notes, Contains("unit or an up axis of their own"));
}

TEST_CASE("dae: a node or a geometry may occur in several places") {
    const std::string at4 = "<node><translate>4 0 0</translate><instance_node url=\"#n\"/></node>";
    const std::string library = "<library_nodes><node id=\"n\">" + instance + "</node></library_nodes>";
    check(document("<node><instance_node url=\"#n\"/></node>" + at4, mesh(plain), library),
          {same, moved(4, 0, 0)});
    check(document("<node id=\"n\">" + instance + "</node>" + at4), {same, moved(4, 0, 0)});
    check(document(here + node("<translate>4 0 0</translate>")), {same, moved(4, 0, 0)});
}

TEST_CASE("dae: strips, fans, lists and polygons give the triangles of the standard") {
    const auto faces = [](const std::string& kind, const std::string& inside,
                          const std::vector<std::array<int, 3>>& right) {
        check(document(here, mesh("<" + kind + ">" + input + inside + "</" + kind + ">")), {same}, right);
    };
    faces("tristrips", "<p>0 1 2 3</p><p>3 2 1</p>", {{0, 1, 2}, {2, 1, 3}, {3, 2, 1}});
    faces("trifans", "<p>0 1 2 3</p>", {{0, 1, 2}, {0, 2, 3}});
    faces("polylist", "<vcount>3 0 3</vcount><p>0 2 1 0 1 3</p>", plain_faces);
    faces("polygons", "<p>0 2 1</p><p>0 1 3</p>", plain_faces);
    faces("triangles", "<p>0 2 1 0 1 3</p>", plain_faces);
}

TEST_CASE("dae: a param without a name is skipped; without any name the first three numbers are a point") {
    const auto with = [](const std::string& numbers, int stride, const std::string& params) {
        check(document(here, mesh_of(source("p", numbers, 4, stride, params), plain)), {same});
    };
    with("9 0 0 0 9 2 0 0 9 0 1 0 9 0 0 0.5", 4, "<param/>" + params);
    with("0 9 0 0 2 9 0 0 0 9 1 0 0 9 0 0.5", 4,
         R"(<param name="X"/><param/><param name="Y"/><param name="Z"/>)");
    with(corners, 3, "<param/><param/><param/>");
    with(corners, 3, "");
}

TEST_CASE("dae: a polygon with holes is cut around them") {
    const auto area = [](const std::string& numbers, int count, const std::string& ph) {
        const Scene scene =
            load(document(here, mesh_of(source("p", numbers, count, 3, params),
                                        "<polygons>" + input + "<ph>" + ph + "</ph></polygons>")))
                .scene;
        double sum = 0;
        for (const Corners& c : corners_of(scene)) {
            const double twice = glm::cross(c[1] - c[0], c[2] - c[0]).z;
            CHECK(twice >= 0);   // none is reversed
            sum += twice / 2;
        }
        return std::pair(scene.triangles.size(), sum);
    };
    const std::string outline = "0 0 0 8 0 0 8 6 0 0 6 0 ", hole = "3 2 0 3 4 0 5 4 0 5 2 0 ";
    CHECK(area(outline + hole, 8, "<p>0 1 2 3</p><h>4 5 6 7</h>") == std::pair<std::size_t, double>(8, 44));
    CHECK(area(outline + hole, 8, "<p>0 1 2 3</p><h>7 6 5 4</h>") == std::pair<std::size_t, double>(8, 44));
    // Three holes next to each other, and one behind another; the outline has a notch between them.
    const std::string three = "1 1 0 1 2 0 2 2 0 2 1 0 4 1 0 4 2 0 5 2 0 5 1 0 1 4 0 1 5 0 2 5 0 2 4 0 ";
    const std::string notched = "0 0 0 8 0 0 8 6 0 4 6 0 3 3 0 2.5 6 0 0 6 0 ";
    CHECK(area(outline + three, 16, "<p>0 1 2 3</p><h>4 5 6 7</h><h>8 9 10 11</h><h>12 13 14 15</h>") ==
          std::pair<std::size_t, double>(20, 45));
    const auto [count, sum] =
        area(notched + three, 19, "<p>0 1 2 3 4 5 6</p><h>7 8 9 10</h><h>11 12 13 14</h><h>15 16 17 18</h>");
    CHECK(count == 23);
    CHECK(sum == Approx(48 - 1.5 * 3 / 2 - 3));
}

TEST_CASE("dae: colours come by parameters, a missing one is black, a glowing one needs no light") {
    const auto colour = [](const std::string& text) { return material(text).colour; };
    const std::string reference = "<lambert><diffuse><param ref=\"c\"/></diffuse></lambert>";
    const auto param = [](const char* kind, const char* value) {
        return "<newparam sid=\"c\"><" + std::string(kind) + ">" + value + "</" + kind + "></newparam>";
    };
    const Point wanted(1, 0, 0);
    CHECK(colour(drawn_with("<lambert>" + std::string(red) + "</lambert>")) == wanted);
    CHECK(colour(drawn_with(reference, param("float4", "1 0 0 1"))) == wanted);
    CHECK(colour(drawn_with(reference, param("float3", "1 0 0"))) == wanted);
    CHECK(colour(drawn_with(reference, {}, param("float4", "1 0 0 1"))) == wanted);
    CHECK(colour(drawn_with(reference, param("float4", "0 1 0 1"), {},
                            "<setparam ref=\"c\"><float4>1 0 0 1</float4></setparam>")) == wanted);
    const SceneFolder folder;
    CHECK_THAT(complaint(folder.write("a.dae", drawn_with(reference))), Contains("'c'"));
    CHECK(colour(drawn_with("<phong><ambient><color>1 1 1 1</color></ambient></phong>")) == Point(0));
    const std::string emission = "<emission><color>1 0 0 1</color></emission>";
    const Material glowing = material(drawn_with("<constant>" + emission + "</constant>"));
    CHECK(glowing.colour == wanted);
    CHECK(glowing.ambient == 1);
    CHECK(glowing.diffuse == 0);
    CHECK_THAT(
        load(drawn_with("<lambert>" + emission + "<diffuse><color>0 1 0 1</color></diffuse></lambert>"))
            .notes,
        Contains("1 material with emission and a diffuse colour"));
    const Told lost = load(document("<node>" + instance + "</node>"));
    CHECK_THAT(lost.notes, Contains("1 primitive whose material is not in the file, drawn grey"));
}

TEST_CASE("dae: a material's transparency follows the four modes of the standard") {
    const std::string half = "0.5 0.5 0.5 1";
    CHECK(transmitted("opaque=\"A_ONE\"", "0 0 0 0.5", "0.5") == Approx(0.75));
    CHECK(transmitted("", "0 0 0 0.5", "0.5") == Approx(0.75));
    CHECK(transmitted("opaque=\"A_ZERO\"", "0 0 0 0.5", "0.5") == Approx(0.25));
    CHECK(transmitted("opaque=\"RGB_ZERO\"", half, "0.5") == Approx(0.25));
    CHECK(transmitted("opaque=\"RGB_ONE\"", half, "0.5") == Approx(0.75));
    CHECK(transmitted("opaque=\"RGB_ONE\"", "0 0 0 1", "1") == 1);
    CHECK(transmitted("opaque=\"RGB_ONE\"", "0 1 0 1", "1") == Approx(1 - 0.71516));
    CHECK(transmitted("", "", "0.5") == Approx(0.5));
    CHECK(transmitted("opaque=\"A_ONE\"", "1 1 1 1", "0") == 1);
    CHECK(transmitted("", "1 1 1 1", "0") == 0);   // as programs at the time of 1.4.0 meant it
    CHECK(transmitted("", "1 1 1 1", "0.25", "FBX COLLADA exporter") == Approx(0.25));
}

TEST_CASE("dae: a skin has the pose of its joints, a morph has the weights of the file") {
    // A vertex: 0.75 of joint J at (4, 0, 0), 0.25 of joint K at (0, 8, 0), after the bind shape.
    check(document(skinned, mesh(plain), skin("2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1", one, "0.75 0.25")),
          {[](const Point& p) { return 2.0 * p + Point(3, 2, 0); }});
    // Bound at its place, J moves nothing. Weights that sum to 2 are scaled, with a note.
    const std::string bound = "1 0 0 -4 0 1 0 0 0 0 1 0 0 0 0 1";
    check(document(skinned, mesh(plain), skin(one, bound, "1 0")), {same});
    check(document(skinned, mesh(plain), skin(one, one, "1.5 0.5")), {moved(3, 2, 0)});
    CHECK_THAT(load(document(skinned, mesh(plain), skin(one, one, "1.5 0.5"))).notes,
               Contains("4 point") && Contains("do not sum to 1") && Contains("1 skin"));
    const std::string alone = "<node><instance_controller url=\"#c\"/></node>";
    const Told lost = load(document(alone, mesh(plain), skin(one, one, "1 0")));
    CHECK(corners_of(lost.scene)[0][2] == Point(2, 0, 0));
    CHECK_THAT(lost.notes, Contains("2 joint") && Contains("as it was bound"));

    const std::string both = alone + node("<translate>9 0 0</translate>");
    check(document(both, mesh(plain) + target, morph("0", "NORMALIZED")), {same, moved(9, 0, 0)});
    check(document(alone, mesh(plain) + target, morph("0.5", "NORMALIZED")), {moved(0, 2, 0)});
    // RELATIVE adds half of (x, y + 4, z).
    check(document(alone, mesh(plain) + target, morph("0.5", "RELATIVE")),
          {[](const Point& p) { return 1.5 * p + Point(0, 2, 0); }});
    const SceneFolder folder;
    for (const auto& [from, to] : {std::pair("<v>0 0 1", "<v>0 0 2"), std::pair("<v>0 0 1 1", "<v>0 0 1 7"),
                                   std::pair("<vcount>2", "<vcount>9")}) {
        std::string text = document(skinned, mesh(plain), skin(one, one, "1 0"));
        text.replace(text.find(from), std::string(from).size(), to);
        CHECK_THAT(complaint(folder.write("a.dae", text)), Contains("a.dae: line") && !Contains("\n"));
    }
}

TEST_CASE("dae: decimal commas are read, and numbers that nothing uses may be nonsense") {
    check(document(here, mesh_of(source("p", "0 0 0 2,0 0 0 0 1,0 0 0 0 0,5", 4, 3, params), plain)), {same});
    check(document(here, mesh_of(source("p", corners + " NaN INF 0", 5, 3, params), plain)), {same});
    const SceneFolder folder;
    CHECK_THAT(complaint(folder.write(
                   "a.dae",
                   document(here, mesh_of(source("p", "0 0 0 NaN 0 0 0 1 0 0 0 0.5", 4, 3, params), plain)))),
               Contains("vertex 1 is not finite"));
}
