// Our own scene format, a JSON file; scenes/README.md describes it.
#pragma once
#include <filesystem>
#include <string_view>

#include "model/scene/placed.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

struct JsonLoad {
    PlacedScene scene;
    bool has_lights;   ///< the file has the key "lights", though the list may be empty: then it is to be as
                       ///< dark as that
};

/// Throws UserError naming the file and the path of the value, for example "desk.json: objects[2].scale must
/// be ...".
JsonLoad load_json_scene(const std::filesystem::path& path, Loading& loading);

/// The same of a text that has been read; `path` names the file in sentences, and its folder holds what the
/// text refers to.
JsonLoad read_json_scene(const std::filesystem::path& path, std::string_view text, Loading& loading);

}   // namespace rayclock
