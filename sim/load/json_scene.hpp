// Our own scene format, a JSON file; scenes/README.md describes it.
#pragma once
#include <filesystem>

#include "model/scene/scene.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

struct JsonLoad {
    Scene scene;
    bool has_lights;   ///< the file has the key "lights", though the list may be empty: then it is to be as dark as that
};

/// Throws UserError naming the file and the path of the value, for example "desk.json: objects[2].scale must be ...".
JsonLoad load_json_scene(const std::filesystem::path& path, Loading& loading);

} // namespace rayclock
