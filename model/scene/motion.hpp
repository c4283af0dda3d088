#pragma once
// The motion of a scene: nodes over time, and the objects attached to them. scenes/README.md has its form in
// files.
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

/// A space that moves in another one, which is an earlier node or the scene. It scales first, then rotates,
/// then moves, as objects do. Alternatively it has one matrix.
struct MotionNode {
    std::string name;                        ///< for messages
    std::optional<std::uint32_t> parent{};   ///< an earlier node
    glm::dmat4 matrix{1};                    ///< used unless is_parts; `matrices` overrides it over time
    Track<glm::dmat4> matrices{};
    bool is_parts = false;   ///< use the next three and their tracks instead of a matrix
    glm::dvec3 translate{0};
    glm::dquat rotation{1, 0, 0, 0};
    glm::dvec3 scale{1};
    Track<glm::dvec3> translates{}, scales{};
    Track<glm::dquat> rotations{};
};

/// An instance attached to a node, with its place in the node's space.
struct AttachedInstance {
    std::uint32_t instance = 0, node = 0;
    glm::dmat4 place{1};
};

/// The scene's camera over time. Each of its values has a track, or the whole camera is attached to a node.
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

/// All motion in a PlacedScene.
struct Motion {
    std::vector<MotionNode> nodes;            ///< parents before children
    std::vector<AttachedInstance> attached;   ///< instances that move
    CameraMotion camera;
    std::vector<LightMotion> lights;
    std::vector<Deforming> deforming;   ///< meshes whose corners move; each mesh at most once

    bool empty() const { return attached.empty() && camera.empty() && lights.empty() && deforming.empty(); }
    /// Returns the time of the last key of all tracks, in seconds; 0 without keys.
    double length() const;
};

/// Returns the place of every node in the scene at a time.
std::vector<glm::dmat4> node_places(const Motion& motion, double time);

struct PlacedScene;

/// Sets the places of moving instances, the corners of deforming meshes, the camera and the lights for a
/// time. An instance may become flat. Throws UserError with the node's name and the time if a number is
/// infinite or extreme.
void pose(PlacedScene& scene, double time);

/// True if a map makes solids flat, has extreme lengths, or is not finite.
bool is_singular(const glm::dmat4& m);

}   // namespace rayclock
