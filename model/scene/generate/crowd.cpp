// A marching crowd: size * size walkers in rows. Each has a trunk with a head, and two arms and two legs that
// swing about shoulder and hip. All walk ahead by one metre per second, and the camera moves with them.
#include "model/scene/generate/generate.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <glm/gtc/matrix_transform.hpp>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

constexpr int head_size = 1;
constexpr double walk_seconds = 2;   // seconds: two steps of each leg, after which the pose repeats
constexpr std::uint64_t box_triangles = 12, limbs = 4;

/// Writes the box between two corners.
void box(MeshWriter& mesh, const glm::dvec3& lo, const glm::dvec3& hi) {
    const auto at = [&](int c) {
        return glm::dvec3(c & 1 ? hi.x : lo.x, c & 2 ? hi.y : lo.y, c & 4 ? hi.z : lo.z);
    };
    for (const auto& [a, b, c, d] :
         {std::array{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}})
        mesh.flat({at(a), at(b), at(c), at(d)});
}

SharedMesh shared(const std::string& name, Scene&& scene) {
    return {name, std::move(scene.vertices), std::move(scene.normals), std::move(scene.triangles)};
}

/// Upright from the hip at 0; the feet are 0.9 m below it.
SharedMesh trunk() {
    Scene scene;
    MeshWriter mesh(scene);
    box(mesh, {-0.22, 0, -0.12}, {0.22, 0.6, 0.12});
    const Scene head = make_icosphere(head_size);
    const auto first = static_cast<std::uint32_t>(scene.vertices.size());
    for (std::size_t i = 0; i < head.vertices.size(); ++i)
        mesh.vertex(glm::dvec3(0, 0.78, 0) + 0.15 * head.vertices[i], head.normals[i]);
    for (const Triangle& t : head.triangles)
        mesh.triangle(first + t.vertex[0], first + t.vertex[1], first + t.vertex[2]);
    return shared("trunk", std::move(scene));
}

SharedMesh limb() {
    Scene scene;
    MeshWriter mesh(scene);
    box(mesh, {-0.07, -0.85, -0.08}, {0.07, 0, 0.08});
    return shared("limb", std::move(scene));
}

class Crowd {
public:
    explicit Crowd(int size) : size_(size) {
        MeshWriter ground(scene_.own);
        ground.material({.name = "ground", .colour{0.6, 0.62, 0.55}, .diffuse = 0.5});
        const double far = 2.0 * size + 8;
        ground.flat({{far, 0, far}, {far, 0, -far}, {-far, 0, -far}, {-far, 0, far}});
        for (const glm::dvec3& colour :
             {glm::dvec3(0.75, 0.25, 0.2), {0.2, 0.45, 0.75}, {0.8, 0.7, 0.3}, {0.3, 0.6, 0.35}})
            ground.material({.name = "coat", .colour = colour, .diffuse = 0.6});
        ground.material({.name = "cloth", .colour{0.25, 0.25, 0.3}, .diffuse = 0.6});
        scene_.own.lights = white_lights({{8, 20, 12}, {-15, 12, 6}});
        scene_.meshes = {trunk(), limb()};
    }

    PlacedScene make() {
        for (int row = 0; row < size_; ++row)
            for (int column = 0; column < size_; ++column) walker(row, column);
        const glm::dvec3 eye(0.9 * size_, 1.2 + 0.45 * size_, 4 + 0.9 * size_), at(0, 0.6, 0),
            ahead(0, 0, walk_seconds);
        scene_.own.camera = Camera{eye, at, {0, 1, 0}, 45};
        scene_.motion.camera.eye = {{0, walk_seconds}, {eye, eye + ahead}, Interpolation::linear};
        scene_.motion.camera.at = {{0, walk_seconds}, {at, at + ahead}, Interpolation::linear};
        pose(scene_, 0);
        return std::move(scene_);
    }

private:
    static constexpr std::uint32_t coats = 4;

    void walker(int row, int column) {
        const auto number = static_cast<std::uint32_t>(row * size_ + column);
        const std::string name = "walker " + std::to_string(number);
        const double phase = chance(number), step = 1.1;
        MotionNode body{.name = name};
        body.is_parts = true;
        const glm::dvec3 from(step * (column - 0.5 * (size_ - 1)), 0.9, -step * (row - 0.5 * (size_ - 1)));
        body.translates = {
            {0, walk_seconds}, {from, from + glm::dvec3(0, 0, walk_seconds)}, Interpolation::linear};
        const std::uint32_t node = add(body, 0, 1 + number % coats);
        for (int limb = 0; limb < int(limbs); ++limb) {
            const bool is_leg = limb < 2, is_left = limb % 2 == 0;
            MotionNode swings{.name = name + ", limb " + std::to_string(limb), .parent = node};
            swings.is_parts = true;
            swings.translate = {is_left ? -(is_leg ? 0.12 : 0.3) : (is_leg ? 0.12 : 0.3), is_leg ? 0 : 0.58,
                                0};
            swings.scale = is_leg ? glm::dvec3(1.05) : glm::dvec3(0.7, 0.75, 0.7);
            const double side = is_left == is_leg ? 1 : -1;
            for (int k = 0; k <= 16; ++k) {
                const double angle =
                    side * (is_leg ? 0.5 : 0.6) * std::sin(2 * std::numbers::pi * (k / 8.0 + phase));
                swings.rotations.times.push_back(walk_seconds * k / 16);
                swings.rotations.values.push_back(glm::angleAxis(angle, glm::dvec3(1, 0, 0)));
            }
            add(swings, 1, is_leg ? 1 + coats : 1 + number % coats);
        }
    }

    std::uint32_t add(const MotionNode& node, std::uint32_t mesh, std::uint32_t material) {
        const auto number = static_cast<std::uint32_t>(scene_.motion.nodes.size());
        scene_.motion.nodes.push_back(node);
        scene_.motion.attached.push_back(
            {static_cast<std::uint32_t>(scene_.instances.size()), number, glm::dmat4(1)});
        scene_.instances.push_back({node.name, mesh, glm::dmat4(1), material});
        return number;
    }

    int size_;
    PlacedScene scene_;
};

}   // namespace

std::uint64_t crowd_triangles(int size) {
    const auto n = static_cast<std::uint64_t>(size);
    return n * n * (box_triangles * (1 + limbs) + icosphere_triangles(head_size)) + 2;
}

PlacedScene make_crowd(int size) { return Crowd(size).make(); }

}   // namespace rayclock
