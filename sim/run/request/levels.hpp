#pragma once
// Checks that a machine's levels can draw a scene.
#include "model/core/config.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// Throws UserError if a machine with the configuration's levels cannot draw the scene, or not with --ground.
void check_levels(const Scene& scene, const Config& config, bool finished, bool ground);

}   // namespace rayclock
