#pragma once
#include <string>

#include "model/core/progress.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// SCENE of the command line: a built-in name with an optional size, or a file (.obj .ply .stl .glb .gltf .json).
/// The result has passed check_scene() and has a light; the camera may be absent. Throws UserError.
Scene load_scene(const std::string& spec, const Progress& progress = {});

} // namespace rayclock
