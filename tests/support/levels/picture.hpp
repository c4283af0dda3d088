#pragma once
// What the camera rays of a picture hit, walked in two levels: what, without when.
#include "model/compile/levels/levels.hpp"
#include "model/scene/hit.hpp"
#include "tests/support/levels/walk.hpp"

namespace rayclock {

struct LevelsPicture {
    Frame frame;
    HitFrame hits;
    std::vector<Closest> answers;   ///< the same, as a machine would give them
    LevelCounts counts;
};

/// `threads` 0 for all cores; the same for any number of them.
LevelsPicture trace_levels(const LevelsImage& levels, const Camera& camera, FrameSize size,
                           const Config& config, int threads = 0, const Progress& progress = {});

}   // namespace rayclock
