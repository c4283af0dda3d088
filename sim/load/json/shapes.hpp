#pragma once
// A mesh of a JSON scene that has several shapes, each at its own time; see scenes/README.md, Motion.
#include <filesystem>

#include "model/scene/placed.hpp"
#include "sim/files/json_value.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// Returns a scene with one mesh, which deforms, and one instance of it. `list` has the form [{"time": 0,
/// "file": "a.obj"}, ...], and the files lie in `folder`. Throws UserError unless all files have the same
/// faces and the same number of vertices.
PlacedScene shapes_of(const JsonValue& list, const std::filesystem::path& folder, Loading& loading);

}   // namespace rayclock
