// glTF files of other programs: faults that can be repaired are repaired with a note, supported features are
// drawn, and a warning names the rest.
#include <catch2/catch.hpp>

#include <cmath>

#include <glm/geometric.hpp>

#include "tests/support/scenes/animated.hpp"
#include "tests/support/scenes/gltf_deforming.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

using Notes = std::vector<std::string>;

struct Read {
    PlacedScene placed;
    Scene scene;
    Notes notes;   ///< without the name of the file
};

Read read(const Animated& file, double time = 0) {
    const SceneFolder folder;
    const Progress silent;
    Loading loading(silent);
    Read made;
    const std::string path = folder.write("a.glb", glb_of(file.json.dump(), file.bytes));
    made.placed = load_mesh_file(path, loading);
    pose(made.placed, time);
    made.scene = flat_copy(made.placed);
    for (const std::string& note : loading.notes()) made.notes.push_back(note.substr(path.size() + 2));
    return made;
}

Json& primitive(Animated& file) { return file.json["meshes"][0]["primitives"][0]; }

/// Returns the octahedron with this single material.
Read with_material(const Json& material, const Notes& notes = {}) {
    Animated file;
    file.json["materials"] = Json::array({material});
    primitive(file)["material"] = 0;
    Read made = read(file);
    CHECK(made.scene.materials.size() == 1);
    CHECK(made.notes == notes);
    return made;
}

const std::vector<Corners> octahedron = Octahedron().corners();

void check_alike(const std::vector<Corners>& a, const std::vector<Corners>& b) {
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) CHECK(glm::length(a[i][k] - b[i][k]) < 1e-6);
}

double area(const Corners& t) { return glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) / 2; }

std::size_t seen(const Scene& scene) {
    std::size_t count = 0;
    for (const Corners& t : corners_of(scene)) count += area(t) > 0;
    return count;
}

}   // namespace

TEST_CASE("glTF: unlit and emissive colours do not depend on the lights") {
    const Material unlit = with_material({{"extensions", {{"KHR_materials_unlit", Json::object()}}},
                                          {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0.5, 0, 1}}}}})
                               .scene.materials[0];
    CHECK(unlit.colour == glm::dvec3(1, 0.5, 0));
    CHECK(unlit.ambient == 1);
    CHECK(unlit.diffuse == 0);
    CHECK(unlit.highlight == 0);
    CHECK(unlit.mirror == 0);
    const Json black{{"baseColorFactor", {0, 0, 0, 1}}};
    const Material lamp =
        with_material({{"emissiveFactor", {0.25, 0.5, 0}},
                       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 2}}}}},
                       {"pbrMetallicRoughness", black}})
            .scene.materials[0];
    CHECK(lamp.colour == glm::dvec3(0.5, 1, 0));
    CHECK(lamp.ambient == 1);
    CHECK(lamp.diffuse == 0);
    with_material(
        {{"emissiveFactor", {0, 0, 1}}, {"name", "sign"}},
        {"1 material giving off light of a colour other than that of the surface, which is not drawn "
         "('sign')"});
    with_material({{"extensions", {{"KHR_materials_sheen", Json::object()}}}},
                  {"1 material with extensions that are not drawn ('material 0')"});
}

TEST_CASE("glTF: specular and glossiness become colour, mirror and highlight") {
    const auto material = [](const Json& own) {
        return with_material({{"extensions", {{"KHR_materials_pbrSpecularGlossiness", own}}},
                              {"pbrMetallicRoughness", {{"baseColorFactor", {0, 1, 0, 1}}}}})
            .scene.materials[0];
    };
    const Material orange =
        material({{"diffuseFactor", {1, 0.1, 0, 1}}, {"specularFactor", {0, 0, 0}}, {"glossinessFactor", 0}});
    CHECK(glm::length(orange.colour - glm::dvec3(1, 0.1, 0)) < 0.05);
    CHECK(orange.mirror == 0);
    CHECK(orange.highlight == 0);
    // A polished metal has no diffuse colour, and its specular colour is the mirror's.
    const Material gold = material({{"diffuseFactor", {0, 0, 0, 1}}, {"specularFactor", {1, 0.75, 0.25}}});
    CHECK(gold.mirror == Approx(1).margin(1e-3));
    CHECK(glm::length(gold.colour - glm::dvec3(1, 0.75, 0.25)) < 0.02);
    const Material plastic =
        material({{"diffuseFactor", {0.5, 0.25, 0.125, 1}}, {"specularFactor", {0.04, 0.04, 0.04}}});
    CHECK(glm::length(plastic.colour - glm::dvec3(0.5, 0.25, 0.125)) < 1e-3);
    CHECK(plastic.mirror == Approx(0).margin(1e-3));
    CHECK(plastic.highlight == 0.5);
}

TEST_CASE("glTF: a constant opacity below the cutoff is invisible") {
    Animated file;
    file.json["materials"] = {
        {{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 0.2}}}}},
        {{"alphaMode", "MASK"},
         {"alphaCutoff", 0.1},
         {"pbrMetallicRoughness", {{"baseColorFactor", {0, 1, 0, 0.2}}}}}};
    file.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 1}}};
    file.json["scenes"] = {{{"nodes", {0, 1}}}};
    primitive(file)["material"] = 0;
    file.json["meshes"].push_back(file.json["meshes"][0]);
    file.json["meshes"][1]["primitives"][0]["material"] = 1;
    const Read made = read(file);
    CHECK(corners_of(made.scene) == octahedron);
    CHECK(made.scene.materials.at(made.scene.triangles[0].material).colour == glm::dvec3(0, 1, 0));
    CHECK(made.scene.materials.at(made.scene.triangles[0].material).transmit == 0);
    CHECK(made.notes == Notes{"1 invisible primitive left out: opacity below the cutoff of the material "
                              "(alphaMode MASK) ('meshes[0].primitives[0]')"});
}

TEST_CASE("glTF: a file without a visible surface gives an empty picture") {
    Animated file;
    file.json["materials"] = {
        {{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 0.2}}}}}};
    primitive(file)["material"] = 0;
    const Read made = read(file);
    CHECK(seen(made.scene) == 0);
    CHECK(bounds(made.scene).lo == glm::dvec3(-1, -1.75, -1.5));
    CHECK(bounds(made.scene).hi == glm::dvec3(3, 2.5, 4));
    CHECK_NOTHROW(check_scene(made.scene, "test"));
    CHECK(made.notes.size() == 1);
}

TEST_CASE("glTF: orthographic cameras and spot lights are reported") {
    Animated file;
    file.json["cameras"] = {
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 0}}}}};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}}};
    file.json["nodes"] = {
        {{"mesh", 0}},
        {{"camera", 0}},
        {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"translation", {0, 9, 0}}}};
    file.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
    const Read made = read(file);
    CHECK(!made.scene.camera);
    CHECK(made.scene.lights.size() == 1);
    CHECK(made.notes == Notes{"1 orthographic camera left out ('nodes[1]')",
                              "1 spot light drawn as a point light ('nodes[2]')"});
}

TEST_CASE(
    "glTF: vertex colours multiply the colour of the material, and a face gets the mean of its corners") {
    Animated file;
    std::vector<float> colours;
    for (int v = 0; v < 6; ++v)   // 0, 2 and 4 are red: the first triangle
        colours.insert(colours.end(), {v % 2 ? 0.0f : 1.0f, 0, v % 2 ? 0.5f : 0.0f, 1});
    primitive(file)["attributes"]["COLOR_0"] = file.accessor(colours, "VEC4", 4);
    file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 1, 1, 1}}}}}};
    primitive(file)["material"] = 0;
    const Read made = read(file);
    const auto colour = [](const Scene& scene, std::size_t t) {
        return scene.materials[scene.triangles[t].material].colour;
    };
    CHECK(corners_of(made.scene) == octahedron);
    CHECK(colour(made.scene, 0) == glm::dvec3(0.5, 0, 0));                                // 0 2 4
    CHECK(glm::length(colour(made.scene, 1) - glm::dvec3(1.0 / 3, 0, 0.5 / 3)) < 1e-6);   // 2 1 4
    CHECK(made.notes == Notes{"6 faces with corners of different colours, drawn in their mean"});
    // The same for a deforming mesh, and for one in two places.
    Animated moving = file;
    primitive(moving)["targets"] = {{{"POSITION", moving.accessor(std::vector<float>(18, 0), "VEC3", 3)}}};
    moving.channel(0, "weights", {0, 1}, {0, 1});
    CHECK(colour(read(moving).scene, 0) == glm::dvec3(0.5, 0, 0));
    file.json["nodes"].push_back({{"mesh", 0}});
    file.json["scenes"] = {{{"nodes", {0, 1}}}};
    CHECK(colour(read(file).scene, 8) == glm::dvec3(0.5, 0, 0));
}

TEST_CASE("glTF: EXT_mesh_gpu_instancing draws a mesh in many places") {
    Animated file;
    const float c = std::sqrt(0.5f);
    file.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    Json& node = file.json["nodes"][0];
    node["translation"] = {10, 0, 0};
    node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", file.accessor({0, 0, 0, 0, 6, 0, 0, 0, 9}, "VEC3", 3)},
        {"ROTATION", file.accessor({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, c, c}, "VEC4", 4)},
        {"SCALE", file.accessor({1, 1, 1, 2, 2, 2, 1, 1, 1}, "VEC3", 3)}};
    const Read made = read(file);
    std::vector<Corners> wanted;
    for (int copy = 0; copy < 3; ++copy)
        for (const Corners& t : octahedron) {
            Corners moved;
            for (std::size_t k = 0; k < 3; ++k)
                moved[k] = glm::dvec3(10, 0, 0) + (copy == 0   ? t[k]
                                                   : copy == 1 ? 2.0 * t[k] + glm::dvec3(0, 6, 0)
                                                               : glm::dvec3(-t[k].y, t[k].x, t[k].z + 9));
            wanted.push_back(moved);
        }
    check_alike(corners_of(made.scene), wanted);
    CHECK(made.placed.meshes.size() == 1);
    CHECK(made.placed.instances.size() == 3);
    CHECK(made.notes.empty());
    file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
        file.accessor({1, 1, 1}, "VEC3", 3);
    check_says(file.says(), {"SCALE", "1 places", "has 3"});
}

TEST_CASE("glTF: weights of a skin count by their proportion, and without any the first joint carries") {
    const auto weighted = [](std::vector<float> of_third) {
        Skinned file;
        std::vector<float> all;
        std::string joints;
        for (std::size_t v = 0; v < 6; ++v) {
            const std::vector<float> own = v == 3 ? of_third : std::vector<float>{0, 1, 0, 0};
            all.insert(all.end(), own.begin(), own.end());
            joints += std::string("\1\0\0\1", 4);
        }
        Json& attributes = primitive(file)["attributes"];
        attributes["WEIGHTS_0"] = file.accessor(all, "VEC4", 4);
        attributes["JOINTS_0"] = file.byte_accessor(joints);
        return file;
    };
    const auto vertex = [](const Skinned& file) { return read(file, 1).placed.meshes[0].vertices[3]; };
    const glm::dvec3 rest = Octahedron().vertices[3];
    const std::vector<Matrix> joints = Skinned().joints(1);
    CHECK(glm::length(vertex(weighted({0.2f, 0.5f, 0, 0})) -
                      (2.0 / 7 * of(joints[1], rest) + 5.0 / 7 * of(joints[0], rest))) < 1e-6);
    CHECK(glm::length(vertex(weighted({255, 0, 0, 0})) - of(joints[1], rest)) < 1e-6);
    CHECK(glm::length(vertex(weighted({0, 0, 0, 0})) - of(joints[1], rest)) < 1e-6);
    CHECK(
        read(weighted({0, 0.7f, 0, 0})).notes ==
        Notes{
            "1 vertex of a skin with weights that do not sum to 1, taken by their proportion ('vertex 3')"});
    CHECK(read(weighted({0, 0, 0, 0})).notes ==
          Notes{"1 vertex of a skin without a weight, carried by the first joint ('vertex 3')"});
    CHECK(read(weighted({0, 0.5f, 0.5f, 0})).notes.empty());
    // A missing joint is a fault only if it has a weight.
    Skinned out = weighted({0, 1, 0, 0});
    primitive(out)["attributes"]["JOINTS_0"] =
        out.byte_accessor(std::string("\7\0\0\1\7\0\0\1\7\0\0\1\7\0\0\1\7\0\0\1\7\0\0\1", 24));
    CHECK(out.says().empty());
}

TEST_CASE("glTF: a key of scale 0 hides its node until the next one") {
    Animated file;
    file.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {4, 0, 0}}}};
    file.json["scenes"] = {{{"nodes", {0, 1}}}};
    file.channel(0, "scale", {0, 1, 2}, {1, 1, 1, 0, 0, 0, 1, 1, 1}, "STEP");
    CHECK(seen(read(file, 0).scene) == 16);
    CHECK(seen(read(file, 1.5).scene) == 8);
    CHECK(seen(read(file, 2).scene) == 16);
    for (const double time : {0.0, 1.5}) CHECK_NOTHROW(check_scene(read(file, time).scene, "test"));
    // A mesh that is flat along one axis is visible as a sheet, and keeps its normals.
    Animated flat;
    flat.channel(0, "scale", {0, 2}, {1, 1, 1, 1, -1, 1});
    const Read made = read(flat, 1);
    for (const Corners& t : corners_of(made.scene))
        for (const glm::dvec3& p : t) CHECK(p.y == 0);
    CHECK(seen(made.scene) == 8);
}

TEST_CASE("glTF: values that no triangle uses may be NaN") {
    Animated file;
    const float nan = NAN;
    std::vector<float> positions, normals;
    for (const glm::dvec3& v : Octahedron().vertices)
        for (int k = 0; k < 3; ++k) positions.push_back(float(v[k])), normals.push_back(k == 2 ? 1.0f : 0.0f);
    positions.insert(positions.end(), {nan, 0, 0, 0, 0, INFINITY});
    normals.insert(normals.end(), {0, 0, 1, 0, 0, 1});
    normals[5] = nan;   // of the second vertex
    primitive(file)["attributes"] = {{"POSITION", file.accessor(positions, "VEC3", 3)},
                                     {"NORMAL", file.accessor(normals, "VEC3", 3)}};
    const Read made = read(file);
    CHECK(corners_of(made.scene) == octahedron);
    CHECK(made.notes == Notes{"1 normal with components that are not finite, left out "
                              "('meshes[0].primitives[0].attributes.NORMA...')",
                              "2 unused vertices with coordinates that are not finite, left out (the first: "
                              "'meshes[0].primitives[0].attributes.POSIT...')"});
    const Triangle& t = made.scene.triangles[1];   // 2 1 4
    const Corners at = octahedron[1];
    CHECK(made.scene.normals[t.vertex[0]] == glm::dvec3(0, 0, 1));
    CHECK(glm::length(made.scene.normals[t.vertex[1]] -
                      glm::normalize(glm::cross(at[1] - at[0], at[2] - at[0]))) < 1e-6);
    // The same for a deforming mesh.
    file.json["nodes"][0]["weights"] = {1};
    std::vector<float> moves(24, 0);
    moves[18] = nan;
    primitive(file)["targets"] = {{{"POSITION", file.accessor(moves, "VEC3", 3)}}};
    CHECK(corners_of(read(file).scene) == octahedron);
    moves[0] = nan;
    primitive(file)["targets"] = {{{"POSITION", file.accessor(moves, "VEC3", 3)}}};
    check_says(file.says(), {"nan", "element 0"});
    // Meshes and materials that no node uses are not checked.
    Animated other;
    other.json["meshes"].push_back(
        {{"primitives", {{{"attributes", {{"POSITION", 99}}}, {"material", 99}}}}});
    other.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", "red"}}}}};
    CHECK(other.says().empty());
}

TEST_CASE("glTF: an accessor without data is zeros, unless the mesh is compressed") {
    Animated file;
    file.json["accessors"].push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", 6}});
    primitive(file)["targets"] = {{{"POSITION", 2}}};
    file.json["nodes"][0]["weights"] = {1};
    const Read made = read(file);
    CHECK(corners_of(made.scene) == octahedron);
    CHECK(made.notes == Notes{"1 accessor without a buffer view, taken as zeros ('accessors[2]')"});
    primitive(file)["attributes"]["POSITION"] = 2;
    primitive(file)["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
    check_says(file.says(), {"meshes[0].primitives[0]", "compressed by KHR_draco_mesh_compression"});
    Animated without;
    without.json["meshes"][0]["primitives"].push_back({{"attributes", {{"NORMAL", 0}}}});
    const Read left = read(without);
    CHECK(corners_of(left.scene) == octahedron);
    CHECK(left.notes == Notes{"1 primitive without positions left out ('meshes[0].primitives[1]')"});
}
