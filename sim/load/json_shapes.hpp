// A mesh of a JSON scene that has several shapes, each at its time: scenes/README.md, Motion.
#pragma once
#include <filesystem>

#include "model/scene/placed.hpp"
#include "sim/files/json_value.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// `list`: [{"time": 0, "file": "a.obj"}, ...]. The result has one mesh, which deforms, and one instance of
/// it. Files lie in `folder`. Throws UserError unless all files have the same faces over as many vertices.
PlacedScene shapes_of(const JsonValue& list, const std::filesystem::path& folder, Loading& loading);

}   // namespace rayclock
