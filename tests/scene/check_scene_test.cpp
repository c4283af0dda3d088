// check_scene(): what is refused, and with which sentence.
#include <limits>

#include <catch2/catch.hpp>

#include "tests/scene/mesh_measures.hpp"

using namespace rayclock;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(), not_a_number = std::numeric_limits<double>::quiet_NaN();

Scene good_scene() {
    Scene scene;
    scene.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    scene.triangles = {{{0, 1, 2}, 0}, {{0, 2, 3}, 1}};
    scene.materials.resize(2);
    scene.materials[1].name = "brass";
    scene.lights.resize(1);
    return scene;
}

template <class Change> std::string sentence(const Change& change) {
    Scene scene = good_scene();
    change(scene);
    return refusal([&] { check_scene(scene, "bunny.obj"); });
}

} // namespace

TEST_CASE("A sound scene passes, degenerate triangles and all", "[scene][check]") {
    CHECK(sentence([](Scene&) {}).empty());
    CHECK(sentence([](Scene& s) { s.triangles[0].vertex = {1, 1, 1}; }).empty());
    CHECK(sentence([](Scene& s) { s.lights.clear(); }).empty());
    CHECK(sentence([](Scene& s) { s.camera = Camera{}; }).empty());
    CHECK(sentence([](Scene& s) { s.normals.assign(4, {0, 0, 1}); }).empty());
    CHECK(sentence([](Scene& s) { s.vertices[3] = {8e307, -8e307, std::numeric_limits<double>::denorm_min()}; }).empty());
}

TEST_CASE("Missing parts and wrong indices are named", "[scene][check]") {
    CHECK(sentence([](Scene& s) { s.triangles.clear(); }) == "bunny.obj: there are no triangles");
    CHECK(sentence([](Scene& s) { s.materials.clear(); }) == "bunny.obj: there are no materials");
    CHECK(sentence([](Scene& s) { s.triangles[1].vertex[2] = 4; }) == "bunny.obj: triangle 1 uses vertex 4 (counted from 0), and there are 4");
    CHECK(sentence([](Scene& s) { s.triangles[0].vertex[0] = 0xffffffff; }) ==
          "bunny.obj: triangle 0 uses vertex 4294967295 (counted from 0), and there are 4");
    CHECK(sentence([](Scene& s) { s.triangles[1].material = 2; }) == "bunny.obj: triangle 1 uses material 2 (counted from 0), and there are 2");
    CHECK(sentence([](Scene& s) { s.normals.resize(3); }) == "bunny.obj: there are 3 normals for 4 vertices");
    CHECK(sentence([](Scene& s) { s = Scene{}; }) == "bunny.obj: there are no triangles");
}

TEST_CASE("Every number must be finite", "[scene][check]") {
    CHECK(sentence([](Scene& s) { s.vertices[2].y = not_a_number; }) == "bunny.obj: vertex 2 (counted from 0) is (0, nan, 0), not a finite point");
    CHECK(sentence([](Scene& s) { s.vertices[0].x = -infinite; }) == "bunny.obj: vertex 0 (counted from 0) is (-inf, 0, 0), not a finite point");
    CHECK(sentence([](Scene& s) { s.vertices[3].z = infinite; }) == "bunny.obj: vertex 3 (counted from 0) is (0, 0, inf), not a finite point");
    CHECK(sentence([](Scene& s) { s.lights[0].position.z = not_a_number; }) == "bunny.obj: light 0 (counted from 0) is at (0, 0, nan), not a finite point");
    CHECK(sentence([](Scene& s) { s.lights[0].colour.x = infinite; }) ==
          "bunny.obj: light 0 (counted from 0) has the colour (inf, 1, 1), not finite numbers");
    CHECK(sentence([](Scene& s) { s.background.x = not_a_number; }) == "bunny.obj: the background (nan, 0.361, 0.753) is not a colour");
    for (double Material::*member : {&Material::ambient, &Material::diffuse, &Material::highlight, &Material::shine,
                                     &Material::mirror, &Material::transmit, &Material::index})
        for (const double bad : {not_a_number, infinite})
            CHECK(sentence([&](Scene& s) { s.materials[1].*member = bad; }) ==
                  "bunny.obj: material 1 'brass' has a value that is not a finite number");
    CHECK(sentence([](Scene& s) { s.materials[1].colour.z = not_a_number; }) ==
          "bunny.obj: material 1 'brass' has a value that is not a finite number");
}

TEST_CASE("An extent beyond a double is refused", "[scene][check]") {
    CHECK(sentence([](Scene& s) { s.vertices[0].x = 1e308, s.vertices[1].x = -1e308; }) ==
          "bunny.obj: the scene reaches from (-1e+308, 0, 0) to (1e+308, 1, 1), further than a double can tell");
}

TEST_CASE("The scene's camera is checked", "[scene][check]") {
    CHECK(sentence([](Scene& s) { s.camera = Camera{{1, 2, 3}, {1, 2, 3}, {0, 1, 0}, 45}; }) ==
          "bunny.obj: the camera's eye and the point it looks at are the same, (1, 2, 3)");
    CHECK(sentence([](Scene& s) { s.camera = Camera{{1, 2, 3}, {0, 0, 0}, {0, 1, 0}, not_a_number}; }) ==
          "bunny.obj: the camera's angle must lie between 0 and 180 degrees, not nan");
}

TEST_CASE("Bounds cover used vertices only", "[scene][check]") {
    Scene scene = good_scene();
    scene.triangles.pop_back();
    const Bounds box = bounds(scene);
    CHECK(box.lo == glm::dvec3(0, 0, 0));
    CHECK(box.hi == glm::dvec3(1, 1, 0));
    scene.triangles.clear();
    scene.name = "empty";
    CHECK(refusal([&] { bounds(scene); }) == "empty: there are no triangles");
}
