#pragma once
// The machine's scene in the units of the given scene, and whether it is close enough to the given scene.
//
// The reference traces it in the later stages (finished.hpp). Corners, spheres, planes and lights lie on the
// lattice, and colours and weights have the machine's bits. Corner normals do not change, because Guide
// rounds them. Each change is compared with the bound that the documents state for it.
#include <string>
#include <vector>

#include "sim/judge/paths/placed.hpp"

namespace rayclock {

struct SnappedScene {
    Scene scene;
    std::vector<std::string> faults;   ///< a sentence for each kind of change that exceeds its bound
};

/// `placed` is null with one level.
SnappedScene snapped_scene(const FrameInputs& inputs, const PlacedWorld* placed);

/// Returns only the faults, for a scene of triangles that is not shaded.
std::vector<std::string> snapping_faults(const FrameInputs& inputs, const PlacedWorld* placed);

/// Returns the camera with its eye at the machine's lattice point.
Camera snapped_camera(const FrameInputs& inputs);

}   // namespace rayclock
