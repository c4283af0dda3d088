// Values over time, nested nodes, and placements, compared with formulas that share nothing with the tracks.
#include <catch2/catch.hpp>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "model/scene/motion.hpp"
#include "model/scene/placed.hpp"

namespace rayclock::test::tracks_test {

using namespace rayclock;

namespace {

glm::dquat about_z(double degrees) { return glm::angleAxis(degrees * M_PI / 180, glm::dvec3(0, 0, 1)); }

/// Returns the angle in degrees by which a rotation about z turns the x axis.
double angle_of(const glm::dquat& turn) {
    const glm::dvec3 x = turn * glm::dvec3(1, 0, 0);
    return std::atan2(x.y, x.x) * 180 / M_PI;
}

}   // namespace

TEST_CASE("a track keeps its ends, and goes straight between its keys or jumps", "[motion]") {
    Track<double> track{{1, 2, 4}, {10, 20, 0}, Interpolation::linear};
    CHECK(track.at(-5, 7) == 10);
    CHECK(track.at(1, 7) == 10);
    CHECK(track.at(1.25, 7) == 12.5);
    CHECK(track.at(2, 7) == 20);
    CHECK(track.at(3, 7) == 10);
    CHECK(track.at(99, 7) == 0);
    track.interpolation = Interpolation::step;
    CHECK(track.at(1.999, 7) == 10);
    CHECK(track.at(2, 7) == 20);
    CHECK(track.at(3.999, 7) == 20);
    CHECK(Track<double>{}.at(3, 7) == 7);
}

TEST_CASE("rotations are slerped: evenly, on the shorter way, and stay rotations", "[motion]") {
    const Track<glm::dquat> track{{0, 2}, {about_z(10), about_z(90)}, Interpolation::linear};
    for (const double t : {0.0, 0.5, 1.0, 1.7, 2.0}) {
        const glm::dquat turn = track.at(t, {});
        CHECK(angle_of(turn) == Approx(10 + 40 * t).margin(1e-9));
        CHECK(glm::length(turn) == Approx(1).epsilon(1e-12));
    }
    const Track<glm::dquat> back{{0, 1}, {about_z(170), about_z(-170)}, Interpolation::linear};
    CHECK(std::abs(angle_of(back.at(0.5, {}))) == Approx(180));
}

TEST_CASE("a cubic track is the Hermite spline through its keys with its tangents", "[motion]") {
    // For the polynomial p(t) = t^3 - 2 t^2 + 3 t - 1 between t = 1 and 3, a cubic spline is the polynomial
    // itself.
    const auto p = [](double t) { return ((t - 2) * t + 3) * t - 1; };
    const auto slope = [](double t) { return (3 * t - 4) * t + 3; };
    Track<double> track{{1, 3}, {slope(1), p(1), slope(1), slope(3), p(3), slope(3)}, Interpolation::cubic};
    for (const double t : {1.0, 1.3, 2.0, 2.9, 3.0}) CHECK(track.at(t, 0) == Approx(p(t)));
    CHECK(track.at(0, 0) == p(1));
    CHECK(track.at(9, 0) == p(3));
}

TEST_CASE("nodes move in their parents, and what hangs at them moves with both", "[motion]") {
    PlacedScene scene;
    scene.meshes.push_back({"m", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {{{0, 1, 2}, 0}}});
    scene.own.materials.emplace_back();
    scene.own.lights.push_back({{0, 0, 0}, {1, 1, 1}});
    MotionNode turns{.name = "arm"};
    turns.is_parts = true;
    turns.translate = {5, 0, 0};
    turns.rotations = {{0, 1}, {about_z(0), about_z(90)}, Interpolation::linear};
    MotionNode slides{.name = "hand", .parent = 0};
    slides.is_parts = true;
    slides.translates = {{0, 1}, {{1, 0, 0}, {3, 0, 0}}, Interpolation::linear};
    slides.scale = glm::dvec3(2);
    scene.motion.nodes = {turns, slides};
    const glm::dmat4 rest = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, 7));
    scene.instances = {{"i", 0, glm::dmat4(1), {}}, {"still", 0, glm::dmat4(1), {}}};
    scene.motion.attached = {{0, 1, rest}};
    LightMotion light;
    light.node = 1, light.point = {1, 0, 0};
    scene.motion.lights = {light};
    CHECK(scene.motion.length() == 1);
    for (const double t : {0.0, 0.25, 1.0, 2.0}) {
        pose(scene, t);
        const double s = std::min(t, 1.0), a = s * M_PI / 2, c = std::cos(a), d = std::sin(a);
        const auto world = [&](const glm::dvec3& q) {   // of a point in the hand's space
            const glm::dvec3 h = 2.0 * q + glm::dvec3(1 + 2 * s, 0, 0);
            return glm::dvec3(5 + c * h.x - d * h.y, d * h.x + c * h.y, h.z);
        };
        const auto is_at = [&](const glm::dvec3& p) {
            return glm::dvec3(scene.instances[0].place * glm::dvec4(p, 1));
        };
        for (const glm::dvec3& p : {glm::dvec3(0), {1, 2, 3}})
            CHECK(glm::length(is_at(p) - world(p + glm::dvec3(0, 0, 7))) < 1e-12);
        CHECK(glm::length(scene.own.lights[0].position - world({1, 0, 0})) < 1e-12);
        CHECK(scene.instances[1].place == glm::dmat4(1));
    }
    // On its way to a mirror image a mesh is flat for an instant. A flat mesh is legal; lengths beyond the
    // limit are refused.
    scene.motion.nodes[1].scales = {{0, 2}, {{1, 1, 1}, {-1, 1, 1}}, Interpolation::linear};
    pose(scene, 1);
    CHECK(glm::length(scene.instances[0].place[0]) == 0);
    CHECK(glm::length(scene.instances[0].place[2]) == Approx(1));
    scene.motion.nodes[1].scales = {{0, 2}, {{1, 1, 1}, {1e200, 1, 1}}, Interpolation::linear};
    CHECK_THROWS_WITH(pose(scene, 1), Catch::Contains("hand at 1 s moves or scales its mesh out of range"));
}

TEST_CASE("scenes that move have exactly the triangles that they say, and hundreds of instances",
          "[motion]") {
    const auto check = [](const std::string& spec, std::size_t instances, std::uint64_t triangles,
                          double length) {
        INFO(spec);
        PlacedScene scene = make_placed(spec);
        CHECK(scene.instances.size() == instances);
        CHECK(scene.motion.attached.size() == instances);   // all move
        CHECK(primitive_count(scene) == triangles);
        CHECK(builtin_counts(spec, Primitives::triangles).triangles == triangles);
        CHECK(scene.motion.length() == length);
        const auto begin = scene.instances;
        pose(scene, length / 4);
        std::size_t still = 0;
        for (std::size_t i = 0; i < instances; ++i) still += scene.instances[i].place == begin[i].place;
        CHECK(still == 0);
    };
    check("clockwork:16", 256, 256 * 572 + 2, 4);
    check("clockwork:3", 9, 9 * 572 + 2, 4);
    check("crowd:10", 500, 100 * 140 + 2, 2);
    check("flight:400", 400, 400 * 320 + 2, 4);
    check("flight:7", 7, 7 * 320 + 2, 4);
}

TEST_CASE("gears that turn each other stay in each other's gaps", "[motion]") {
    // In the plane, whenever a tooth or a gap is between them. The corners of two flanks touch, as in Haines'
    // gears, which do not move.
    PlacedScene scene = make_placed("clockwork:2");
    const SharedMesh& gear = scene.meshes[0];
    for (int k = 0; k < 12; ++k) {
        pose(scene, k / 18.0);
        const glm::dmat4 back = glm::inverse(scene.instances[1].place);
        const auto crosses = [&](const glm::dvec3& p) {   // crossings of a ray along x with the outline
            bool inside = false;
            for (std::size_t i = 0; i < 144; ++i) {
                const glm::dvec3 &a = gear.vertices[i], &b = gear.vertices[(i + 1) % 144];
                if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
                    inside = !inside;
            }
            return inside;
        };
        std::size_t met = 0;
        for (std::size_t i = 0; i < 144; ++i)
            met += crosses(glm::dvec3(back * scene.instances[0].place * glm::dvec4(gear.vertices[i], 1)));
        CHECK(met <= 2);
    }
    CHECK(gear.vertices.size() == 288);
    pose(scene, 0.02);   // 90 degrees per second, one in this direction and its neighbours in the other
    const auto degrees = [&](std::size_t i) {
        return std::atan2(scene.instances[i].place[0][1], scene.instances[i].place[0][0]) * 180 / M_PI;
    };
    CHECK(degrees(0) == Approx(1.8));
    CHECK(degrees(1) == Approx(5 - 1.8));
    CHECK(degrees(2) == Approx(5 - 1.8));
    CHECK(degrees(3) == Approx(1.8));
}

}   // namespace rayclock::test::tracks_test
