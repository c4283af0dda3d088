// The lights of a scene that brings none.
#pragma once
#include "model/scene/scene.hpp"

namespace rayclock {

/// If the scene has no light: a key light over the right shoulder of its camera (or of the camera that would
/// be fitted) and a weak fill light from the left, both at distances that go with the size of the scene.
void add_missing_lights(Scene& scene);

}   // namespace rayclock
