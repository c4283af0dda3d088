#pragma once
// The ground of --ground.
#include "model/scene/scene.hpp"

namespace rayclock {

/// Adds a grey square below a scene that has a camera, at right angles to the camera's up axis. It lies below
/// the lowest point by a thousandth of the scene's radius, so that nothing touches it. It is four times as
/// wide as the scene. Its two triangles follow the scene's own.
void lay_ground(Scene& scene);

}   // namespace rayclock
