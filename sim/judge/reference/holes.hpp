#pragma once
// Light that passes through the holes of textures.
#include "model/scene/scene.hpp"
#include "sim/judge/reference/geometry.hpp"

namespace rayclock {

/// Errors within which a hole may be decided either way.
struct HoleSlack {
    double weight = 0;   ///< of a hit's u and v
    double moved = 0;    ///< distance by which a hit may move in its triangle's plane, in scene units
    double alpha = 0;    ///< of the cut-off
};
/// Whether something lies in the way to a light. The two differ only where the slack leaves a hole open.
struct Hidden {
    bool surely = false, possibly = false;
};

/// Looks along a path up to `distance`. A triangle with a cut-off lets light pass where the alpha of its
/// texture's level 0 is below the cut-off. More than most_holes holes hide the light.
Hidden hidden_at(const RefGeometry& geometry, const Scene& scene, const RefPath& path, double distance,
                 const HoleSlack& slack = {});

}   // namespace rayclock
