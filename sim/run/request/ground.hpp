#pragma once
#include "model/scene/scene.hpp"

namespace rayclock {

/// Lays a grey square under a scene that has a camera: across the camera's up axis, below the lowest point by
/// a thousandth of the scene's reach, so that nothing touches it, and four times as wide as the scene. Two
/// triangles after the scene's own.
void lay_ground(Scene& scene);

}   // namespace rayclock
