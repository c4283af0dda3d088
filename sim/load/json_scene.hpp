// Our own scene format, a JSON file; scenes/README.md describes it.
#pragma once
#include <filesystem>

#include "model/core/progress.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// Throws UserError naming the file and the path of the value, for example "desk.json: objects[2].scale must be ...".
Scene load_json_scene(const std::filesystem::path& path, const Progress& progress);

} // namespace rayclock
