// Keyframes of a JSON scene: scenes/README.md says what they mean.
#pragma once
#include "model/scene/placed.hpp"
#include "sim/files/json_value.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// The most that a rotation may turn between two keys, degrees.
constexpr double most_degrees = 360'000;
/// Times of keys lie within 0 and this, seconds.
constexpr double latest_time = 1e6;

/// Where something stands: in the space of a node of a Motion, or in the scene.
struct Where {
    glm::dmat4 place{1};
    std::optional<std::uint32_t> node{};
};
/// A node for it, to be the parent of others; nothing for the scene itself.
std::optional<std::uint32_t> anchor(const Where& where, Motion& motion);
/// Where an object or instance stands in what is above it: by its place, or by a new node with its keyframes.
Where where_of(const JsonValue& in, const Where& above, Motion& motion, Loading& loading);
/// A part's nodes once more, in another space; the number of the first.
std::uint32_t add_nodes(const Motion& part, const Where& where, Motion& motion);
/// A part's meshes that deform, once more: they are the meshes from `first_mesh` on. Their joints move in the
/// mesh's space, wherever it is placed.
void add_deforming(const Motion& part, std::uint32_t first_mesh, Motion& motion);
/// By instance: how it hangs at a node, or null.
std::vector<const Hung*> hung_of(const PlacedScene& part);

/// Times of all keys: they rise, and there are two or more, so no motion has the length 0.
std::vector<double> key_times_of(const JsonValue& keyframes);

/// A node from the keyframes of an object or an instance, in no parent.
MotionNode node_of(const JsonValue& keyframes, Loading& loading);

/// Of a camera. `first` becomes the camera at the first key.
CameraMotion camera_motion_of(const JsonValue& keyframes, Camera& first);

/// Of the light with this number. `first` becomes the light at the first key.
LightMotion light_motion_of(const JsonValue& keyframes, std::uint32_t light, Light& first);

}   // namespace rayclock
