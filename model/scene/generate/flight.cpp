// Balls in flight over a ground. Every ball is thrown up, falls and is thrown again, once in four seconds,
// along a parabola of sixteen straight pieces. Two of three are mirrors. One of two lights moves in a circle.
#include "model/scene/generate/generate.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

constexpr int ball_size = 2, pieces = 16;
constexpr double flight_seconds = 4;   // seconds

void begin(PlacedScene& scene, double side) {
    MeshWriter ground(scene.own);
    ground.material({.name = "ground", .colour{0.75, 0.7, 0.6}, .diffuse = 0.6});
    ground.flat({{side, 0, side}, {side, 0, -side}, {-side, 0, -side}, {-side, 0, side}});
    ground.material({.name = "mirror",
                     .colour{0.95, 0.95, 1},
                     .diffuse = 0.15,
                     .highlight = 0.4,
                     .shine = 60,
                     .mirror = 0.8});
    ground.material({.name = "gold",
                     .colour{1, 0.8, 0.35},
                     .diffuse = 0.25,
                     .highlight = 0.4,
                     .shine = 40,
                     .mirror = 0.6});
    ground.material({.name = "clay", .colour{0.8, 0.35, 0.25}, .diffuse = 0.8});
    scene.own.lights = white_lights({{0.8 * side, 1.6 * side, side}, {side, side, 0}});
    scene.own.camera = Camera{{0.5 * side, 0.9 * side, 1.9 * side}, {0, 0.3 * side, 0}, {0, 1, 0}, 45};
    LightMotion round{.light = 1};
    for (int k = 0; k <= pieces; ++k) {
        const double angle = 2 * std::numbers::pi * k / pieces;
        round.position.times.push_back(flight_seconds * k / pieces);
        round.position.values.push_back({side * std::cos(angle), side, side * std::sin(angle)});
    }
    scene.motion.lights.push_back(round);
}

/// Returns a ball thrown from one point of a square to another and back.
MotionNode thrown(std::uint32_t number, double side) {
    const auto across = [&](std::uint32_t k) { return 0.85 * side * (2 * chance(8 * number + k) - 1); };
    const glm::dvec3 from(across(0), 0, across(1)), to(across(2), 0, across(3));
    const double height = side * (0.2 + 0.7 * chance(8 * number + 4)), phase = chance(8 * number + 5);
    MotionNode node{.name = "ball " + std::to_string(number)};
    node.is_parts = true;
    node.scale = glm::dvec3(0.12 + 0.14 * chance(8 * number + 6));
    for (int k = 0; k <= pieces; ++k) {
        // There and back, so that the end equals the beginning.
        const double s = std::fmod(double(k) / pieces + phase, 1.0), way = s < 0.5 ? 2 * s : 2 - 2 * s;
        glm::dvec3 at = from + way * (to - from);
        at.y = 0.3 + height * 4 * way * (1 - way);
        node.translates.times.push_back(flight_seconds * k / pieces);
        node.translates.values.push_back(at);
    }
    return node;
}

}   // namespace

std::uint64_t flight_triangles(int size) {
    return static_cast<std::uint64_t>(size) * icosphere_triangles(ball_size) + 2;
}

PlacedScene make_flight(int size) {
    PlacedScene scene;
    const double side = 1.5 + 0.45 * std::sqrt(size);
    begin(scene, side);
    Scene ball = make_icosphere(ball_size);
    scene.meshes.push_back(
        {"ball", std::move(ball.vertices), std::move(ball.normals), std::move(ball.triangles)});
    for (std::uint32_t i = 0; i < std::uint32_t(size); ++i) {
        scene.motion.nodes.push_back(thrown(i, side));
        scene.motion.attached.push_back({i, i, glm::dmat4(1)});
        scene.instances.push_back({scene.motion.nodes.back().name, 0, glm::dmat4(1), 1 + i % 3});
    }
    pose(scene, 0);
    return scene;
}

}   // namespace rayclock
