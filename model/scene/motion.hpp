// What moves in a scene, and how: nodes over time, and what hangs at them. scenes/README.md has the form in
// files.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "model/scene/deform.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/track.hpp"

namespace rayclock {

/// A space that moves in another one, which is a node before it or the scene. It is scaled first, then
/// turned, then moved, as objects are; or it has one matrix.
struct MotionNode {
    std::string name;                        ///< in sentences
    std::optional<std::uint32_t> parent{};   ///< an earlier node
    glm::dmat4 matrix{1};   ///< if none of translate, turn and scale moves, this or `matrices`
    Track<glm::dmat4> matrices{};
    bool is_parts = false;   ///< the next three, and their tracks, instead of a matrix
    glm::dvec3 translate{0};
    glm::dquat turn{1, 0, 0, 0};
    glm::dvec3 scale{1};
    Track<glm::dvec3> translates{}, scales{};
    Track<glm::dquat> turns{};
};

/// An instance that hangs at a node: where it stands in the node's space.
struct Hung {
    std::uint32_t instance = 0, node = 0;
    glm::dmat4 place{1};
};

/// The scene's camera over time: each of its values has a track, or the whole hangs at a node.
struct CameraMotion {
    Track<glm::dvec3> eye{}, at{}, up{};
    Track<double> fov{};   ///< degrees
    std::optional<std::uint32_t> node{};
    Camera seen{};   ///< with a node: the camera in its space

    bool empty() const { return eye.empty() && at.empty() && up.empty() && fov.empty() && !node; }
};

struct LightMotion {
    std::uint32_t light = 0;   ///< index in Scene::lights
    Track<glm::dvec3> position{}, colour{};
    std::optional<std::uint32_t> node{};
    glm::dvec3 point{0};   ///< with a node: the light in its space
};

/// Everything that moves in a PlacedScene.
struct Motion {
    std::vector<MotionNode> nodes;   ///< parents before children
    std::vector<Hung> hung;          ///< instances that move
    CameraMotion camera;
    std::vector<LightMotion> lights;
    std::vector<Deforming> deforming;   ///< meshes whose corners move; each mesh once at most

    bool empty() const { return hung.empty() && camera.empty() && lights.empty() && deforming.empty(); }
    /// Time of the last key of all tracks, seconds; 0 without any.
    double length() const;
};

/// Where every node stands in the scene at a time.
std::vector<glm::dmat4> node_places(const Motion& motion, double time);

struct PlacedScene;

/// Sets the places of instances that move, the corners of meshes that deform, the camera and the lights to
/// where they are at a time. An instance may become flat. Throws UserError with the node's name and the time
/// if a number has become infinite, or larger than any use.
void pose(PlacedScene& scene, double time);

/// A map that makes solids flat, or has lengths that are beyond any use, or is not finite.
bool is_singular(const glm::dmat4& m);

}   // namespace rayclock
