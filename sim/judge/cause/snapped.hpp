#pragma once
// The scene as the machine has it, in the units of the given scene, and whether it is near enough to that.
//
// For the ladder (finished.hpp): the reference traces it. Corners, spheres, planes and lights lie on the
// lattice, colours and weights have the machine's bits. Corner normals stay as they are given: Guide rounds
// them. Each change is held against the bound that the documents state for it.
#include <string>
#include <vector>

#include "sim/judge/paths/placed.hpp"

namespace rayclock {

struct SnappedScene {
    Scene scene;
    std::vector<std::string> faults;   ///< a sentence for each kind of change that is beyond its bound
};

/// `placed`: of two levels, or null.
SnappedScene snapped_scene(const Asked& asked, const PlacedWorld* placed);

/// The same faults alone, for a scene of triangles that is not shaded.
std::vector<std::string> snapping_faults(const Asked& asked, const PlacedWorld* placed);

/// The camera with its eye where the machine has it.
Camera snapped_camera(const Asked& asked);

}   // namespace rayclock
