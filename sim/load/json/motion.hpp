#pragma once
// Keyframes of a JSON scene, as scenes/README.md defines them. All functions throw UserError if the file is
// wrong.
#include "model/scene/placed.hpp"
#include "sim/files/json_value.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// The largest rotation between two keys, in degrees.
constexpr double max_degrees = 360'000;
/// The latest time of a key, in seconds; the earliest is 0.
constexpr double latest_time = 1e6;

/// A place in the space of a node of a Motion, or in the space of the scene.
struct NodePlace {
    glm::dmat4 place{1};
    std::optional<std::uint32_t> node{};
};
/// Returns a node at this place that can be the parent of others. Returns nothing for the scene's own space.
std::optional<std::uint32_t> anchor(const NodePlace& where, Motion& motion);
/// Returns the place of an object or instance below `above`. Adds a node to `motion` if it has keyframes.
NodePlace where_of(const JsonValue& in, const NodePlace& above, Motion& motion, Loading& loading);
/// Copies a part's nodes below `where` and returns the number of the first copy.
std::uint32_t add_nodes(const Motion& part, const NodePlace& where, Motion& motion);
/// Copies a part's deforming meshes, which become the meshes from `first_mesh` on. Their joints move in the
/// mesh's space, wherever the mesh is placed.
void add_deforming(const Motion& part, std::uint32_t first_mesh, Motion& motion);
/// Returns for each instance how it hangs at a node, or null.
std::vector<const AttachedInstance*> attached_of(const PlacedScene& part);

/// Returns the times of all keys. They must rise, and there must be at least two, so that no motion has the
/// length 0.
std::vector<double> key_times_of(const JsonValue& keyframes);

/// Returns a node without a parent from the keyframes of an object or instance.
MotionNode node_of(const JsonValue& keyframes, Loading& loading);

/// Returns the motion of a camera. `first` becomes the camera at the first key.
CameraMotion camera_motion_of(const JsonValue& keyframes, Camera& first);

/// Returns the motion of the light with this number. `first` becomes the light at the first key.
LightMotion light_motion_of(const JsonValue& keyframes, std::uint32_t light, Light& first);

}   // namespace rayclock
