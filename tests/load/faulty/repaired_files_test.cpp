// Files of other programs with faults and dialects: a fault in something that is drawn is refused. The rest
// is repaired, with one sentence for each kind.
#include <catch2/catch.hpp>

#include <limits>

#include <glm/geometric.hpp>

#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test::repaired_files_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

using Notes = std::vector<std::string>;
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

struct Read {
    Scene scene;
    Notes notes;   ///< without the name of the file

    glm::dvec3 colour(std::size_t triangle) const {
        return scene.materials[scene.triangles[triangle].material].colour;
    }
};

Read read(const SceneFolder& folder, const std::string& name, const std::string& bytes) {
    Read made;
    Notes notes;
    const std::string file = folder.write(name, bytes);
    made.scene = load_scene(file, {}, Primitives::triangles, &notes);
    for (const std::string& note : notes)
        made.notes.push_back(note.starts_with(file + ": ") ? note.substr(file.size() + 2) : note);
    return made;
}

std::string with(std::string text, const std::string& old, const std::string& fresh) {
    const std::size_t at = text.find(old);
    REQUIRE(at != std::string::npos);
    return text.replace(at, old.size(), fresh);
}

std::string with_returns(std::string text) {
    for (char& c : text)
        if (c == '\n') c = '\r';
    return text;
}

const std::string v3 = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const Corners right{glm::dvec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}};

/// Requires one flat triangle, from (0 0 0) over (1 0 0) to (0 1 0).
void check_triangle(const Read& read, const Notes& notes) {
    CHECK(corners_of(read.scene) == std::vector<Corners>{right});
    CHECK(read.scene.normals.empty());
    CHECK(read.notes == notes);
}

std::string ply(const std::string& form, const std::string& more_vertex, const std::string& faces,
                std::size_t vertices = 3) {
    return "ply\nformat " + form + " 1.0\nelement vertex " + std::to_string(vertices) +
           "\nproperty float x\nproperty float y\nproperty float z\n" + more_vertex + faces + "end_header\n";
}
const std::string one_face = "element face 1\nproperty list uchar int vertex_indices\n";

}   // namespace

TEST_CASE("obj: a statement unknown to the format is skipped and reported") {
    const SceneFolder folder;
    check_triangle(
        read(folder, "a.obj", "$ contributed by nobody\n" + v3 + "t interpolateboundary 1/0\nf 1 2 3\n"),
        {"2 lines skipped: OBJ has no such statement (the first: line 1, '$')"});
    CHECK(complaint(folder.write("b.obj", "solid x\nfacet\n")) ==
          folder.name("b.obj") + ": line 1: 'solid' is not an OBJ statement");
}

TEST_CASE("obj: a vertex without coordinates is refused if a face uses it, and reported otherwise") {
    const SceneFolder folder;
    const std::string told = "unused vertex with coordinates that are not finite, left out (line 4, ";
    check_triangle(read(folder, "a.obj", v3 + "v nan nan nan\nf 1 2 3\n"), {"1 " + told + "'nan nan nan')"});
    check_triangle(read(folder, "a.obj", v3 + "v 0 1e39 0\nf 1 2 3\np 4\n"), {"1 " + told + "'0 1e39 0')"});
    check_triangle(
        read(folder, "a.obj", v3 + "v 0 1,5\nv 0\nf 1 2 3\n"),
        {"2 unused vertices with coordinates that are not finite, left out (the first: line 4, '0 1,5')"});
    CHECK(complaint(folder.write("b.obj", v3 + "v 0 nan 0\nf 1 2 3\nf 1 2 4\n")) ==
          folder.name("b.obj") + ": line 4: 'nan' is not a finite number");
    CHECK(complaint(folder.write("b.obj", v3 + "v 0 1\nf 1 2 4\n")) ==
          folder.name("b.obj") + ": line 4: v needs 3 numbers and has 2");
}

TEST_CASE("obj: corners without their normal are flat, and their neighbours stay smooth") {
    const SceneFolder folder;
    check_triangle(read(folder, "a.obj", v3 + "f 1//1 2//1 3//1\n"),
                   {"3 corners with a normal that is not in the file, drawn flat (the first: '1')"});
    check_triangle(read(folder, "a.obj", v3 + "f 1//0 2//-1 3\n"),
                   {"2 corners with a normal that is not in the file, drawn flat (the first: '0')"});
    const Read mixed = read(folder, "b.obj", v3 + "vn 0.6 0 0.8\nvn nan 0 1\nf 1//1 2//2 3//9\n");
    REQUIRE(mixed.scene.normals.size() == 3);
    const auto normal = [&](std::size_t k) {
        return mixed.scene.normals[mixed.scene.triangles[0].vertex[k]];
    };
    CHECK(glm::length(normal(0) - glm::dvec3(0.6, 0, 0.8)) < 1e-6);
    CHECK(normal(1) == glm::dvec3(0, 0, 1));
    CHECK(normal(2) == glm::dvec3(0, 0, 1));
    CHECK(mixed.notes == Notes{"1 normal with components that are not finite, left out (line 5, 'nan 0 1')",
                               "1 corner with a normal that is not in the file, drawn flat ('9')"});
    // A normal may come after the face that uses it.
    CHECK(read(folder, "c.obj", v3 + "f 1//1 2//1 3//1\nvn 0 0 1\n").notes.empty());
}

TEST_CASE("obj: a face has the mean of its vertices' colours") {
    const SceneFolder folder;
    const std::string red = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\n";
    const Read plain = read(folder, "a.obj", red + "v 1 1 0 0.25 0.5 1 1\nf 1 2 3\nf 2 4 3\nf 1 2 3\n");
    CHECK(plain.colour(0) == glm::dvec3(1, 0, 0));
    CHECK(glm::length(plain.colour(1) - glm::dvec3(0.75, 0.5 / 3, 1.0 / 3)) < 1e-6);
    CHECK(plain.scene.triangles[2].material == plain.scene.triangles[0].material);
    CHECK(plain.notes == Notes{"1 face with corners of different colours, drawn in their mean"});
    const Read odd = read(folder, "b.obj", "v 0 0 0 nan nan nan\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n");
    check_triangle(odd,
                   {"1 vertex with a colour that is not finite, drawn without it (line 1, 'nan nan nan')"});
    CHECK(odd.colour(0) == glm::dvec3(1));
    // A weight is not a colour, and a material's colour is multiplied.
    CHECK(read(folder, "c.obj", "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").colour(0).x == Approx(0.8));
    folder.write("m.mtl", "newmtl half\nKd 0.5 0.5 0.5\n");
    CHECK(read(folder, "d.obj", "mtllib m.mtl\n" + red + "usemtl half\nf 1 2 3\n").colour(0) ==
          glm::dvec3(0.5, 0, 0));
}

TEST_CASE("mtl: a material without a name is the default one") {
    const SceneFolder folder;
    folder.write("m.mtl", "newmtl\nKd 1 0 0\n");
    const Read made = read(folder, "a.obj", "mtllib m.mtl\n" + v3 + "usemtl\nf 1 2 3\n");
    check_triangle(made,
                   {folder.name("m.mtl") + ": 1 material without a name, taken as the default (line 1)"});
    CHECK(made.colour(0) == glm::dvec3(1, 0, 0));
}

TEST_CASE("mtl: a senseless value is refused if a face uses the material, and reported otherwise") {
    const SceneFolder folder;
    folder.write("m.mtl", "newmtl good\nKd 1 0 0\nnewmtl bad\nNs nan\nKd 1 2 blue\nnewmtl worse\nd\n");
    const std::string head = "mtllib m.mtl\n" + v3;
    check_triangle(
        read(folder, "a.obj", head + "usemtl good\nf 1 2 3\n"),
        {folder.name("m.mtl") + ": 2 unused materials with values that make no sense, left out (the "
                                "first: 'bad')"});
    CHECK(complaint(folder.write("b.obj", head + "usemtl bad\nf 1 2 3\n")) ==
          folder.name("m.mtl") + ": line 4: 'nan' is not a finite number");
}

TEST_CASE("mtl: emission in the surface's own colour is drawn, and any other colour is reported") {
    const SceneFolder folder;
    folder.write("m.mtl",
                 "newmtl lamp\nKd 0 0 0\nKe 1 0.5 0\nnewmtl both\nKd 0.5 0.25 0\nKe 0.5 0.25 0\n"
                 "newmtl other\nKd 1 0 0\nKe 0 0 1\nnewmtl dark\nKd 1 0 0\nKe 0 0 0\n");
    const auto material = [&](const std::string& name) {
        const Read made = read(folder, "a.obj", "mtllib m.mtl\n" + v3 + "usemtl " + name + "\nf 1 2 3\n");
        const Material& m = made.scene.materials.at(0);
        CHECK(made.notes == (name == "other"
                                 ? Notes{"1 material giving off light of a colour other than that of the "
                                         "surface, which is not drawn ('other')"}
                                 : Notes{}));
        return m;
    };
    const Material lamp = material("lamp"), both = material("both"), dark = material("dark");
    CHECK(lamp.colour == glm::dvec3(1, 0.5, 0));
    CHECK(lamp.ambient == 1);
    CHECK(lamp.diffuse == 0);
    // Emission is added: 1.1 times the colour without light, and 0.9 of it from light.
    CHECK(both.ambient * both.colour.r == Approx(0.5 + 0.1 * 0.5));
    CHECK(both.ambient * both.colour.g == Approx(0.25 + 0.1 * 0.25));
    CHECK(both.diffuse * both.colour.r == Approx(0.9 * 0.5));
    CHECK(both.ambient <= 1);
    CHECK(dark.ambient == 0.1);
    CHECK(material("other").ambient == 0.1);
}

TEST_CASE("lines may end in a carriage return alone") {
    const SceneFolder folder;
    const std::vector<Corners> octahedron = Octahedron().corners();
    check_triangle(read(folder, "a.obj", with_returns(v3 + "f 1 \\\n2 3\n")), {});
    folder.write("m.mtl", with_returns("newmtl a\nKd 1 0 0\n"));
    CHECK(read(folder, "b.obj", with_returns("mtllib m.mtl\n" + v3 + "usemtl a\nf 1 2 3\n")).colour(0) ==
          glm::dvec3(1, 0, 0));
    CHECK(corners_of(read(folder, "a.ply", with_returns(Octahedron().ply_ascii())).scene) == octahedron);
    CHECK(corners_of(read(folder, "a.stl", with_returns(Octahedron().stl_ascii())).scene) == octahedron);
    CHECK(corners_of(read(folder, "a.off", with_returns(Octahedron().off())).scene) == octahedron);
    CHECK(complaint(folder.write("c.obj", with_returns(v3 + "f 1 2 x\n"))) ==
          folder.name("c.obj") + ": line 4: 'x' is not a whole number");
    CHECK(complaint(folder.write("c.obj", with(v3, "\n", "\r\r\n") + "f 1 2 x\n")) ==
          folder.name("c.obj") + ": line 4: 'x' is not a whole number");
}

TEST_CASE("ply: of binary data behind a header whose lines end in a return alone no byte is lost") {
    const SceneFolder folder;
    for (const bool big : {false, true}) {
        std::string bytes = Octahedron().ply_binary(big);
        const std::size_t end = bytes.find("end_header\n") + 11;
        const std::string head = with_returns(bytes.substr(0, end));
        CHECK(corners_of(read(folder, "a.ply", head + bytes.substr(end)).scene) == Octahedron().corners());
        // The first byte of the data equals a line feed: 2^-126 (1 + 10/2^23) as a float, 10 in its last
        // byte.
        if (big) continue;
        const std::string begins = head + '\n' + bytes.substr(end + 1);
        CHECK(corners_of(read(folder, "b.ply", begins).scene)[0][0].x > 3);
        CHECK(corners_of(read(folder, "b.ply", begins).scene)[0][0].x < 3.00001);
    }
}

TEST_CASE("ply: every second triangle of a strip is reversed, and -1 begins a new strip") {
    const SceneFolder folder;
    const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n",
                      corners = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
    const std::vector<Corners> both{right, {glm::dvec3(0, 1, 0), {1, 0, 0}, {1, 1, 0}}};
    const Read one = read(folder, "a.ply", ply("ascii", "", strips, 4) + corners + "4 0 1 2 3\n");
    CHECK(corners_of(one.scene) == both);
    CHECK(one.notes.empty());
    const Read many =
        read(folder, "b.ply", ply("ascii", "", strips, 4) + corners + "12 0 1 2 -1 -1 2 1 3 -1 0 1 -1\n");
    CHECK(corners_of(many.scene) == both);
    std::string binary = ply("binary_big_endian", "", strips, 4);
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 1.f, 1.f, 0.f}) binary += raw(x, true);
    for (const std::int32_t i : {8, 0, 1, 2, 3, -1, 2, 1, 3}) binary += raw(i, true);
    CHECK(corners_of(read(folder, "c.ply", binary).scene) ==
          std::vector<Corners>{both[0], both[1], {both[1][0], both[1][1], both[1][2]}});
    CHECK_THAT(complaint(folder.write("d.ply", ply("ascii", "", strips, 4) + corners + "3 0 1 4\n")),
               Catch::Contains("line 14: vertex index 4 is out of range"));
    CHECK_THAT(complaint(folder.write("e.ply", ply("ascii", "", strips, 4) + corners + "2 0 1\n")),
               Catch::Contains("no triangles"));
}

TEST_CASE("ply: unknown header lines and excess words are skipped and reported") {
    const SceneFolder folder;
    const std::string head = ply("ascii", "", one_face);
    check_triangle(
        read(folder, "a.ply",
             with(head, "element v", "Created by hand\nelement v") +
                 "0 0 0\n1 0 0 7\n0 1 0\n3 0 1 2 255 0 0\n"),
        {"1 line skipped: a PLY header has no such line (line 3, 'Created')",
         "2 lines with more words than the header declares, which are skipped (the first: line 12, '7')"});
}

TEST_CASE("ply: what no face uses may be no number") {
    const SceneFolder folder;
    const std::string more = "property float quality\nproperty int label\n";
    check_triangle(read(folder, "a.ply",
                        ply("ascii", more, one_face, 4) +
                            "0 0 0 nan 1\n1 0 0 inf x\n0 1 0 1 1.5\nnan 0 1e60 0 0\n3 0 1 2\n"),
                   {"1 unused vertex with coordinates that are not finite, left out (line 15)"});
    std::string binary = ply("binary_little_endian", "", one_face, 4);
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, no_number, 0.f}) binary += raw(x);
    check_triangle(read(folder, "b.ply", binary + '\3' + raw(0) + raw(1) + raw(2)),
                   {"1 unused vertex with coordinates that are not finite, left out ('3')"});
    CHECK_THAT(complaint(folder.write("c.ply", binary + '\3' + raw(0) + raw(1) + raw(3))),
               Catch::Contains("c.ply: vertex 3: y is nan, which is not a finite number"));
    CHECK_THAT(
        complaint(folder.write("d.ply", ply("ascii", "", one_face) + "0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n")),
        Catch::Contains("d.ply: line 11: y is inf, which is not a finite number"));
    // A face that is a line draws nothing, whatever it references.
    check_triangle(read(folder, "e.ply",
                        ply("ascii", "", with(one_face, "1", "2")) + "0 0 0\n1 0 0\n0 1 0\n2 0 9\n3 0 1 2\n"),
                   {});
    const std::string normals = "property float nx\nproperty float ny\nproperty float nz\n";
    const Read flat =
        read(folder, "f.ply",
             ply("ascii", normals, one_face) + "0 0 0 0 0 1\n1 0 0 nan 0 0\n0 1 0 0.6 0 0.8\n3 0 1 2\n");
    CHECK(flat.scene.normals[flat.scene.triangles[0].vertex[1]] == glm::dvec3(0, 0, 1));
    CHECK(glm::length(flat.scene.normals[flat.scene.triangles[0].vertex[2]] - glm::dvec3(0.6, 0, 0.8)) <
          1e-6);
    CHECK(flat.notes == Notes{"1 normal with components that are not finite, left out (line 14)"});
}

TEST_CASE("ply: faces have their own colour or the mean of their corners'") {
    const SceneFolder folder;
    const std::string bytes = "property uchar red\nproperty uchar green\nproperty uchar blue\n",
                      corners = "0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n1 1 0 0 51 0\n",
                      faces = "element face 2\nproperty list uchar int vertex_indices\n";
    const Read mean = read(folder, "a.ply", ply("ascii", bytes, faces, 4) + corners + "3 0 1 2\n3 2 1 3\n");
    CHECK(mean.colour(0) == glm::dvec3(1, 0, 0));
    CHECK(glm::length(mean.colour(1) - glm::dvec3(2.0 / 3, 0.2 / 3, 0)) < 1e-6);
    CHECK(mean.notes == Notes{"1 face with corners of different colours, drawn in their mean"});
    const Read own =
        read(folder, "b.ply",
             ply("ascii", "", faces + "property float red\nproperty float green\nproperty float blue\n", 4) +
                 "0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2 0 0.5 1\n3 2 1 3 0.25 0 0\n");
    CHECK(own.colour(0) == glm::dvec3(0, 0.5, 1));
    CHECK(own.colour(1) == glm::dvec3(0.25, 0, 0));
    CHECK(own.notes.empty());
}

TEST_CASE("stl: a binary file may begin with solid and have bytes behind its last facet") {
    const SceneFolder folder;
    const std::string binary = Octahedron().stl_binary();
    CHECK(corners_of(read(folder, "a.stl", binary + "\r\n").scene) == Octahedron().corners());
    CHECK(corners_of(read(folder, "b.stl", binary + std::string(1000, 'x')).scene) == Octahedron().corners());
    CHECK_THAT(complaint(folder.write("c.stl", binary.substr(0, binary.size() - 1))),
               Catch::Contains("cut off") && Catch::Contains("8 triangles take 484 bytes and there are 483"));
}

TEST_CASE("stl: unknown statements and excess words are skipped and reported") {
    const SceneFolder folder;
    const Read made = read(
        folder, "a.stl",
        "solid x\ncolor 1 0 0\nfacet normal nan nan\ncolour 9\nouter loop\nvertex 0 0 0\nvertex 1 0 0 7\n"
        "vertex 0 1 0\nendloop\nendfacet\nendsolid x\n");
    check_triangle(made, {"2 lines skipped: STL has no such statement (the first: line 2, 'color')",
                          "1 line with more than three coordinates; the rest is skipped (line 7, '7')"});
}

}   // namespace rayclock::test::repaired_files_test
