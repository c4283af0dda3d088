// check_scene(): refused scenes and their messages.
#include <limits>

#include <catch2/catch.hpp>

#include "tests/scene/mesh_measures.hpp"

namespace rayclock::test::check_scene_test {

using namespace rayclock;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(),
                 not_a_number = std::numeric_limits<double>::quiet_NaN();

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

}   // namespace

TEST_CASE("a sound scene passes, degenerate triangles and all", "[scene][check]") {
    CHECK(sentence([](Scene&) {}).empty());
    CHECK(sentence([](Scene& s) { s.triangles[0].vertex = {1, 1, 1}; }).empty());
    CHECK(sentence([](Scene& s) { s.lights.clear(); }).empty());
    CHECK(sentence([](Scene& s) { s.camera = Camera{}; }).empty());
    CHECK(sentence([](Scene& s) { s.normals.assign(4, {0, 0, 1}); }).empty());
    CHECK(sentence([](Scene& s) {
              s.vertices[3] = {8e307, -8e307, std::numeric_limits<double>::denorm_min()};
          }).empty());
}

TEST_CASE("missing parts and wrong indices are named", "[scene][check]") {
    CHECK(sentence([](Scene& s) { s.triangles.clear(); }) ==
          "bunny.obj: there is nothing to see: no triangle, no sphere, no plane");
    CHECK(sentence([](Scene& s) { s.materials.clear(); }) == "bunny.obj: there are no materials");
    CHECK(sentence([](Scene& s) { s.triangles[1].vertex[2] = 4; }) ==
          "bunny.obj: triangle 1 uses vertex 4 (counted from 0), and there are 4");
    CHECK(sentence([](Scene& s) { s.triangles[0].vertex[0] = 0xffffffff; }) ==
          "bunny.obj: triangle 0 uses vertex 4294967295 (counted from 0), and there are 4");
    CHECK(sentence([](Scene& s) { s.triangles[1].material = 2; }) ==
          "bunny.obj: triangle 1 uses material 2 (counted from 0), and there are 2");
    CHECK(sentence([](Scene& s) { s.normals.resize(3); }) == "bunny.obj: there are 3 normals for 4 vertices");
    CHECK(sentence([](Scene& s) { s = Scene{}; }) ==
          "bunny.obj: there is nothing to see: no triangle, no sphere, no plane");
}

TEST_CASE("every number must be finite", "[scene][check]") {
    CHECK(sentence([](Scene& s) { s.vertices[2].y = not_a_number; }) ==
          "bunny.obj: vertex 2 (counted from 0) is (0, nan, 0), not a finite point");
    CHECK(sentence([](Scene& s) { s.vertices[0].x = -infinite; }) ==
          "bunny.obj: vertex 0 (counted from 0) is (-inf, 0, 0), not a finite point");
    CHECK(sentence([](Scene& s) { s.vertices[3].z = infinite; }) ==
          "bunny.obj: vertex 3 (counted from 0) is (0, 0, inf), not a finite point");
    CHECK(sentence([](Scene& s) { s.lights[0].position.z = not_a_number; }) ==
          "bunny.obj: light 0 (counted from 0) is at (0, 0, nan), not a finite point");
    CHECK(sentence([](Scene& s) { s.lights[0].colour.x = infinite; }) ==
          "bunny.obj: light 0 (counted from 0) has the colour (inf, 1, 1), not finite numbers");
    CHECK(sentence([](Scene& s) { s.background.x = not_a_number; }) ==
          "bunny.obj: the background (nan, 0.361, 0.753) is not a colour: three numbers within 0 and 1");
    for (double Material::*member :
         {&Material::ambient, &Material::diffuse, &Material::highlight, &Material::shine, &Material::mirror,
          &Material::transmit, &Material::index, &Material::cutoff})
        for (const double bad : {not_a_number, infinite})
            CHECK(sentence([&](Scene& s) { s.materials[1].*member = bad; }) ==
                  "bunny.obj: material 1 'brass' has a value that is not a finite number");
    CHECK(sentence([](Scene& s) { s.materials[1].colour.z = not_a_number; }) ==
          "bunny.obj: material 1 'brass' has a value that is not a finite number");
}

TEST_CASE("an extent beyond a double is refused", "[scene][check]") {
    CHECK(sentence([](Scene& s) { s.vertices[0].x = 1e308, s.vertices[1].x = -1e308; }) ==
          "bunny.obj: the scene reaches from (-1e+308, 0, 0) to (1e+308, 1, 1), further than a double can "
          "tell");
}

TEST_CASE("the scene's camera is checked", "[scene][check]") {
    CHECK(sentence([](Scene& s) {
              s.camera = Camera{{1, 2, 3}, {1, 2, 3}, {0, 1, 0}, 45};
          }) == "bunny.obj: the camera's eye and the point it looks at are the same, (1, 2, 3)");
    CHECK(sentence([](Scene& s) {
              s.camera = Camera{{1, 2, 3}, {0, 0, 0}, {0, 1, 0}, not_a_number};
          }) == "bunny.obj: the camera's angle must lie between 0 and 180 degrees, not nan");
}

TEST_CASE("bounds cover used vertices only", "[scene][check]") {
    Scene scene = good_scene();
    scene.triangles.pop_back();
    const Bounds box = bounds(scene);
    CHECK(box.lo == glm::dvec3(0, 0, 0));
    CHECK(box.hi == glm::dvec3(1, 1, 0));
    scene.triangles.clear();
    scene.name = "empty";
    CHECK(refusal([&] { bounds(scene); }) ==
          "empty: there is nothing to see: no triangle, no sphere, no plane");
}

TEST_CASE("spheres and planes are scenes of their own", "[scene][check]") {
    const auto only = [](const auto& change) {
        return sentence([&](Scene& s) {
            s.triangles.clear();
            s.vertices.clear();
            change(s);
        });
    };
    CHECK(only([](Scene& s) { s.spheres.push_back({}); }).empty());
    CHECK(only([](Scene& s) { s.planes.push_back({}); }).empty());
    CHECK(only([](Scene& s) { s.spheres.push_back({{0, 0, 0}, 1e30, 0}); }).empty());
    CHECK(only([](Scene& s) {
              s.spheres.push_back({{1e308, 0, 0}, 1e308, 0});
          }) ==
          "bunny.obj: the scene reaches from (0, -1e+308, -1e+308) to (inf, 1e+308, 1e+308), further than a "
          "double can tell");
    // A camera and a light inside a sphere may be intended.
    CHECK(only([](Scene& s) {
              s.spheres.push_back({});
              s.camera = Camera{{0, 0, 0.5}, {0, 0, 0}, {0, 1, 0}, 45};
              s.lights[0].position = {0, 0.1, 0};
          }).empty());
}

TEST_CASE("a sphere has a centre, a radius and a material", "[scene][check]") {
    const auto with = [](const Sphere& sphere) {
        return sentence([&](Scene& s) { s.spheres = {{}, sphere}; });
    };
    for (const auto& [radius, text] :
         {std::pair(0.0, "0"), {-0.5, "-0.5"}, {not_a_number, "nan"}, {infinite, "inf"}})
        CHECK(with({{0, 0, 0}, radius, 0}) ==
              std::string("bunny.obj: sphere 1 (counted from 0) has the radius ") + text +
                  ", which must be above 0 and finite");
    CHECK(with({{0, infinite, 0}, 1, 0}) ==
          "bunny.obj: sphere 1 (counted from 0) has the centre (0, inf, 0), not a finite point");
    CHECK(with({{0, 0, 0}, 1, 2}) == "bunny.obj: sphere 1 uses material 2 (counted from 0), and there are 2");
}

TEST_CASE("a plane has a point, two sides that part, and a material", "[scene][check]") {
    const auto with = [](const Plane& plane) { return sentence([&](Scene& s) { s.planes = {plane}; }); };
    CHECK(with({{0, 0, 0}, {1e-30, 0, 0}, {0, 1e30, 0}, 0}).empty());
    CHECK(with({{not_a_number, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0}) ==
          "bunny.obj: plane 0 (counted from 0) goes through (nan, 0, 0), not a finite point");
    CHECK(with({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 0}) ==
          "bunny.obj: plane 0 (counted from 0) has the side (0, 0, 0), not a direction of finite length");
    CHECK(with({{0, 0, 0}, {1, 0, 0}, {0, infinite, 0}, 0}) ==
          "bunny.obj: plane 0 (counted from 0) has the side (0, inf, 0), not a direction of finite length");
    CHECK(with({{0, 0, 0}, {1, 2, 3}, {-2, -4, -6}, 0}) ==
          "bunny.obj: plane 0 (counted from 0) has the sides (1, 2, 3) and (-2, -4, -6), which are parallel");
    CHECK(with({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 7}) ==
          "bunny.obj: plane 0 uses material 7 (counted from 0), and there are 2");
}

TEST_CASE("weights and colours have their ranges", "[scene][check]") {
    for (const auto& [name, member] : {std::pair("ambient", &Material::ambient),
                                       {"diffuse", &Material::diffuse},
                                       {"highlight", &Material::highlight},
                                       {"mirror", &Material::mirror},
                                       {"transmit", &Material::transmit},
                                       {"cutoff", &Material::cutoff}}) {
        for (const double good : {0.0, 1.0})
            CHECK(sentence([&, member = member](Scene& s) { s.materials[1].*member = good; }).empty());
        CHECK(sentence([&, member = member](Scene& s) { s.materials[1].*member = 1.5; }) ==
              std::string("bunny.obj: material 1 'brass' has ") + name +
                  " 1.5, which must lie within 0 and 1");
        CHECK(sentence([&, member = member](Scene& s) { s.materials[1].*member = -0.25; }) ==
              std::string("bunny.obj: material 1 'brass' has ") + name +
                  " -0.25, which must lie within 0 and 1");
    }
    CHECK(sentence([](Scene& s) { s.materials[1].shine = 1e5; }).empty());
    CHECK(sentence([](Scene& s) { s.materials[1].shine = -1; }) ==
          "bunny.obj: material 1 'brass' has shine -1, which must not be negative");
    CHECK(sentence([](Scene& s) { s.materials[1].colour.y = 1.01; }) ==
          "bunny.obj: material 1 'brass' has the colour (0.8, 1.01, 0.8), which must lie within 0 and 1");
    CHECK(sentence([](Scene& s) { s.materials[1].other.x = -1; }) ==
          "bunny.obj: material 1 'brass' has the colour (-1, 0.2, 0.2), which must lie within 0 and 1");
    CHECK(sentence([](Scene& s) { s.background.z = 2; }) ==
          "bunny.obj: the background (0.078, 0.361, 2) is not a colour: three numbers within 0 and 1");
}

TEST_CASE("what transmits has a refractive index", "[scene][check]") {
    const auto with = [](double transmit, double index) {
        return sentence([&](Scene& s) { s.materials[1].transmit = transmit, s.materials[1].index = index; });
    };
    CHECK(with(0.5, 1).empty());
    CHECK(with(0.5, 0.5).empty());
    CHECK(with(0, 0).empty());
    CHECK(with(0.5, 0) == "bunny.obj: material 1 'brass' has the refractive index 0, which must be above 0");
    CHECK(with(0.5, -1.5) ==
          "bunny.obj: material 1 'brass' has the refractive index -1.5, which must be above 0");
}

TEST_CASE("there are at most 64 lights, each at most 16 strong", "[scene][check]") {
    CHECK(sentence([](Scene& s) { s.lights.assign(64, {}); }).empty());
    CHECK(sentence([](Scene& s) { s.lights.assign(1'000'000, {}); }) ==
          "bunny.obj: there are 1000000 lights; the most is 64");
    CHECK(sentence([](Scene& s) { s.lights[0].colour = glm::dvec3(16); }).empty());
    CHECK(sentence([](Scene& s) { s.lights[0].colour.y = 17; }) ==
          "bunny.obj: light 0 (counted from 0) has the colour (1, 17, 1), which must lie within 0 and 16");
    CHECK(sentence([](Scene& s) { s.lights[0].colour.y = -1; }) ==
          "bunny.obj: light 0 (counted from 0) has the colour (1, -1, 1), which must lie within 0 and 16");
}

TEST_CASE("bounds cover spheres; of planes alone, ten squares each way", "[scene][check]") {
    Scene scene = good_scene();
    scene.spheres.push_back({{5, 0, 0}, 2, 0});
    scene.planes.push_back({{100, 100, 100}, {1, 0, 0}, {0, 0, -1}, 0});
    CHECK(bounds(scene).lo == glm::dvec3(0, -2, -2));
    CHECK(bounds(scene).hi == glm::dvec3(7, 2, 2));
    scene.triangles.clear();
    CHECK(bounds(scene).lo == glm::dvec3(3, -2, -2));
    scene.spheres.clear();
    CHECK(bounds(scene).lo == glm::dvec3(95, 100, 95));
    CHECK(bounds(scene).hi == glm::dvec3(105, 100, 105));
}

}   // namespace rayclock::test::check_scene_test
