// Scenes with true spheres: exact counts, the positions of the reference generator, and no other changes.
// Also the scenes that exist only in this form.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "model/scene/builtin.hpp"
#include "model/scene/view.hpp"
#include "tests/scene/mesh_measures.hpp"

namespace rayclock::test::native_test {

using namespace rayclock;

namespace {

Scene native(std::string_view spec) { return make_builtin(spec, Primitives::native); }

PrimitiveCounts counted(const Scene& scene) {
    return {scene.triangles.size(), scene.spheres.size(), scene.planes.size()};
}

const Builtin& builtin(std::string_view name) {
    return *std::find_if(builtins().begin(), builtins().end(),
                         [&](const Builtin& b) { return b.name == name; });
}

struct Sums {
    glm::dvec3 centres{0};
    double squares = 0, radii = 0;
};

Sums sums_of(const Scene& scene) {
    Sums sums;
    for (const Sphere& s : scene.spheres) {
        sums.centres += s.centre;
        sums.squares += glm::dot(s.centre, s.centre);
        sums.radii += s.radius;
    }
    return sums;
}

void check_near(const glm::dvec3& p, const glm::dvec3& expected) {
    CAPTURE(p.x, p.y, p.z);
    CHECK(glm::length(p - expected) < 1.2e-7);
}

}   // namespace

TEST_CASE("native counts are the published ones", "[scene][native]") {
    struct Case {
        const char* name;
        int size;
        PrimitiveCounts counts;
    };
    // Floors and fields are one polygon, cut in two. A cone or cylinder has 24 triangles.
    const auto c = GENERATE(values<Case>({
        {"balls", 1, {2, 10, 0}},
        {"balls", 4, {2, 7381, 0}},
        {"mount", 1, {8, 4, 0}},
        {"mount", 6, {8192, 4, 0}},
        {"rings", 1, {30 * 24 + 2, 30, 0}},
        {"rings", 7, {4200 * 24 + 2, 4200, 0}},
        {"tree", 1, {3 * 24 + 2, 3, 0}},
        {"tree", 11, {4095 * 24 + 2, 4095, 0}},
        {"gears", 2, {4578, 0, 0}},
        {"teapot", 6, {2328, 0, 0}},
        {"tetra", 6, {4096, 0, 0}},
        {"icosphere", 2, {320, 0, 0}},
        {"cornell", 1, {38, 0, 0}},
        {"mirrors", 1, {40, 0, 0}},
        {"spheres", 1, {0, 5, 1}},
        {"plane", 1, {0, 0, 1}},
        {"square", 1, {2, 0, 0}},
        {"room", 1, {34, 0, 0}},
    }));
    CAPTURE(c.name, c.size);
    CHECK(builtin(c.name).counts(c.size, Primitives::native) == c.counts);
    const Scene scene = builtin(c.name).make(c.size, Primitives::native);
    CHECK(counted(scene) == c.counts);
    CHECK_NOTHROW(check_scene(scene, c.name));
    CHECK(scene.vertices.capacity() <= scene.vertices.size() + 64);
    CHECK(scene.spheres.capacity() <= scene.spheres.size() + 64);
}

TEST_CASE("cones and cylinders have as many sides as the name says", "[scene][native]") {
    CHECK(make_builtin("rings:1").vertices == make_builtin("rings:1:12").vertices);
    CHECK(make_builtin("tree:2").vertices == make_builtin("tree:2:12").vertices);
    CHECK(make_builtin("rings:1:40").triangles.size() == 30 * (108 + 80) + 2);
    CHECK(native("tree:2:3").triangles.size() == 7 * 6 + 2);
    CHECK(make_builtin("rings:1:40").name == "rings:1:40");
    CHECK_NOTHROW(check_scene(native("rings:1:40"), "rings"));
    CHECK_THROWS_WITH(make_builtin("rings:1:2"),
                      Catch::Contains("sides") && Catch::Contains("3..1000") && Catch::Contains("'2'"));
    CHECK_THROWS_WITH(make_builtin("rings:1:"), Catch::Contains("sides"));
    CHECK_THROWS_WITH(make_builtin("rings:0:24"), Catch::Contains("size"));
    CHECK_THROWS_WITH(make_builtin("balls:1:24"), Catch::Contains("size") && Catch::Contains("'1:24'"));
    CHECK_THROWS_WITH(make_builtin("rings:19:1000"), Catch::Contains("20000000"));
}

TEST_CASE("native spheres are where the reference generator puts them", "[scene][native]") {
    const Scene balls = native("balls:4");
    check_near(balls.spheres[1].centre, {0.2721655, 0.2721655, 0.5443311});
    CHECK(balls.spheres[1].radius == Approx(1.0 / 6).epsilon(1e-12));
    check_near(balls.spheres.back().centre, {0.4364857, -0.5412422, -0.2222222});
    // The floor's corners are left out: 4 x (12^2 + 12^2 + 0.25) = 1153 of the published 5570.2825, and z =
    // -2 of 1470.1632.
    CHECK(sums_of(balls).radii == Approx(60.5).epsilon(5e-8));
    CHECK(sums_of(balls).centres.z == Approx(1472.1632).epsilon(5e-8));
    CHECK(sums_of(balls).squares == Approx(5570.2825 - 1153).epsilon(5e-8));

    const Scene mount = native("mount:6");
    check_near(mount.spheres[0].centre, {-0.8, 0.8, 1.2082066});
    check_near(mount.spheres[3].centre, {-0.9896104, 0.7491941, 0.9305978});
    for (const Sphere& s : mount.spheres) CHECK(mount.materials[s.material].name == "glass");

    // Half of the listed radii are the spheres', the rest those of both ends of the cylinders: 4200 x 3 x r
    // in total.
    CHECK(sums_of(native("rings:7")).radii == Approx(933.912 / 3).epsilon(5e-8));

    const Scene tree = native("tree:11");
    check_near(tree.spheres[1].centre, {0.4178119, 0, 1.4979289});
    check_near(tree.spheres.back().centre, {-0.3069131, 0.5377147, 3.1362592});
}

TEST_CASE("the form changes the spheres only", "[scene][native]") {
    for (const Builtin& b : builtins()) {
        CAPTURE(b.name);
        const Scene cut = b.make(2 <= b.max_size ? 2 : 1),
                    native = b.make(2 <= b.max_size ? 2 : 1, Primitives::native);
        CHECK(cut.materials.size() == native.materials.size());
        CHECK(cut.lights.size() == native.lights.size());
        CHECK(cut.triangles.size() ==
              native.triangles.size() + 108 * (native.spheres.size() - cut.spheres.size()));
        CHECK(cut.planes.size() == native.planes.size());
        // A tessellated sphere lies inside the true one and touches it.
        const Bounds a = bounds(cut), n = bounds(native);
        CHECK(glm::all(glm::lessThanEqual(n.lo, a.lo + 1e-12)));
        CHECK(glm::all(glm::greaterThanEqual(n.hi, a.hi - 1e-12)));
    }
    CHECK(native("balls:1").normals.empty());
    CHECK(native("mount:2").normals.empty());
    CHECK(native("rings:1").normals.size() == native("rings:1").vertices.size());
}

TEST_CASE("materials reflect and refract as published", "[scene][native]") {
    struct Case {
        const char* scene;
        const char* material;
        double mirror, transmit, index;
    };
    // Haines' materials. The index of opaque materials is never used and is 1 here.
    const auto c = GENERATE(values<Case>({
        {"balls:1", "floor", 0, 0, 1},
        {"balls:1", "balls", 0.5, 0, 1},
        {"gears:1", "ground", 0.6, 0, 1},
        {"gears:2", "gear 0 0 0", 0, 0.8, 1.1},
        {"gears:2", "gear 1 0 0", 0, 0, 1},
        {"mount:1", "glass", 0.1, 0.9, 1.5},
        {"mount:1", "rock", 0, 0, 1},
        {"rings:1", "wall", 0, 0, 1},
        {"rings:1", "ring 3", 0.2, 0, 1},
        {"teapot:1", "odd squares", 0.5, 0, 1},
        {"teapot:1", "even squares", 0.5, 0, 1},
        {"teapot:1", "teapot", 0.25, 0, 1},
        {"tetra:1", "tetra", 0, 0, 1},
        {"tree:1", "field", 0, 0, 1},
        {"tree:1", "wood", 0, 0, 1},
    }));
    CAPTURE(c.scene, c.material);
    const Scene scene = make_builtin(c.scene);
    const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                    [&](const Material& m) { return m.name == c.material; });
    REQUIRE(found != scene.materials.end());
    CHECK(found->mirror == c.mirror);
    CHECK(found->transmit == c.transmit);
    CHECK(found->index == c.index);
}

TEST_CASE("the mirrors are the Cornell box with other walls and one more", "[scene][native]") {
    const Scene box = make_builtin("cornell"), mirrors = make_builtin("mirrors");
    CHECK(box.vertices == mirrors.vertices);
    int reflecting = 0;
    for (const Triangle& t : mirrors.triangles) reflecting += mirrors.materials[t.material].mirror > 0.5;
    CHECK(reflecting == 8);
}

TEST_CASE("a camera is fitted around spheres, and before planes", "[scene][native]") {
    Scene scene = native("balls:1");
    scene.triangles.clear();
    const double aspect = GENERATE(0.5, 2.0);
    const Camera camera = fit_camera(scene, aspect);
    const glm::dvec3 forward = unit_of(camera.at - camera.eye),
                     right = unit_of(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
    double most = 0;   // 1: at the picture's edge
    for (const Sphere& s : scene.spheres)
        for (int i = 0; i < 400; ++i) {
            const double turn = 2.4 * i, z = (i + 0.5) / 200 - 1, r = std::sqrt(1 - z * z);
            const glm::dvec3 p =
                s.centre + s.radius * glm::dvec3(r * std::cos(turn), r * std::sin(turn), z) - camera.eye;
            const double half = glm::dot(p, forward) * std::tan(22.5 * std::numbers::pi / 180);
            most = std::max(
                {most, std::abs(glm::dot(p, up)) / half, std::abs(glm::dot(p, right)) / (half * aspect)});
        }
    CHECK(most < 1);
    CHECK(most > 0.9);
    CHECK(fit_camera(make_builtin("plane"), 1.5).eye.y > 1);
}

}   // namespace rayclock::test::native_test
