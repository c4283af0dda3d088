#pragma once
// Rayclock's own scene format, a JSON file that scenes/README.md describes.
#include <filesystem>
#include <string_view>

#include "model/scene/placed.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// A scene and whether its lights are complete.
struct JsonLoad {
    PlacedScene scene;
    bool has_lights;   ///< the file has the key "lights"; with an empty list, the scene stays dark
};

/// Loads a scene. Throws UserError that names the file and the path of the value, for example "desk.json:
/// objects[2].scale must be ...".
JsonLoad load_json_scene(const std::filesystem::path& path, Loading& loading);

/// Reads a scene from its text. `path` names the file in messages, and its folder holds the files that the
/// text names. Throws UserError.
JsonLoad read_json_scene(const std::filesystem::path& path, std::string_view text, Loading& loading);

}   // namespace rayclock
