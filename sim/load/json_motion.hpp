// Keyframes of a JSON scene: scenes/README.md says what they mean.
#pragma once
#include "model/scene/motion.hpp"
#include "sim/files/json_value.hpp"

namespace rayclock {

/// The most that a rotation may turn between two keys, degrees.
constexpr double most_degrees = 360'000;
/// Times of keys lie within 0 and this, seconds.
constexpr double latest_time = 1e6;

/// A node from the keyframes of an object or an instance, in no parent.
MotionNode node_of(const JsonValue& keyframes);

/// Of a camera. `first` becomes the camera at the first key.
CameraMotion camera_motion_of(const JsonValue& keyframes, Camera& first);

/// Of the light with this number. `first` becomes the light at the first key.
LightMotion light_motion_of(const JsonValue& keyframes, std::uint32_t light, Light& first);

}   // namespace rayclock
