#pragma once
// The default lights of a scene without lights.
#include "model/scene/scene.hpp"

namespace rayclock {

/// Adds two lights if the scene has none. A key light stands over the right shoulder of its camera, and a
/// weak fill light on the left. Their distances are proportional to the size of the scene. A scene without a
/// camera uses the camera that fit_camera() returns.
void add_missing_lights(Scene& scene);

}   // namespace rayclock
