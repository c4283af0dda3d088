// A scene with its instances, for whoever walks two levels; everybody else gets a flat one (request.hpp).
#pragma once
#include "model/scene/placed.hpp"
#include "sim/request/request.hpp"

namespace rayclock {

/// As told_scene().
PlacedScene told_placed(const std::string& spec, const Progress& progress);

/// Gives a scene its camera for a picture of this size, and turns it as it was asked to.
void look(Scene& scene, FrameSize size, const ViewChoice& view);

}   // namespace rayclock
