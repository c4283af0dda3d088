#pragma once
// Traces the camera rays of a picture through two levels, without timing.
#include "model/base/progress.hpp"
#include "model/compile/levels/levels.hpp"
#include "model/scene/hit.hpp"
#include "tests/support/levels/walk.hpp"

namespace rayclock {

struct LevelsPicture {
    Frame frame;
    HitFrame hits;
    std::vector<Closest> answers;   ///< the same hits in the machine's form
    LevelCounts counts;
};

/// Traces a picture. The result does not depend on `threads`; 0 uses all cores.
LevelsPicture trace_levels(const LevelsImage& levels, const Camera& camera, FrameSize size,
                           const Config& config, int threads = 0, const Progress& progress = {});

}   // namespace rayclock
