#pragma once
// Light that passes through the holes of textures.
#include "model/scene/scene.hpp"
#include "sim/judge/reference/geometry.hpp"

namespace rayclock {

/// Errors within which either decision about a hole is right.
struct HoleSlack {
    double weight = 0;   ///< of a hit's u and v
    double moved = 0;    ///< distance by which a hit may move in its triangle's plane, in scene units
    double alpha = 0;    ///< of the cut-off
    double level = 0;    ///< of the level of detail
};
/// Whether something opaque lies in the way to a light. The two flags differ only where the slack leaves the
/// decision about a hole open.
struct Hidden {
    bool surely = false, possibly = false;
};

/// Tests the path up to `distance`. Light passes through a triangle with a cut-off where the alpha of its
/// texture is below the cut-off. The level of the texture is that for a path of length path.travelled and a
/// cosine of 1. More than max_holes holes hide the light. `spread`: sample_spread() of the picture.
Hidden hidden_at(const RefGeometry& geometry, const Scene& scene, const RefPath& path, double distance,
                 double spread, const HoleSlack& slack = {});

}   // namespace rayclock
