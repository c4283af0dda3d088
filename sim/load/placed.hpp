#pragma once
#include "model/scene/placed.hpp"
#include "sim/load/load.hpp"

namespace rayclock {

/// load_scene() with the scene's instances. The flat scene has passed check_scene().
PlacedScene load_placed(const std::string& spec, const Progress& progress = {},
                        Primitives primitives = Primitives::triangles,
                        std::vector<std::string>* notes = nullptr);

}   // namespace rayclock
