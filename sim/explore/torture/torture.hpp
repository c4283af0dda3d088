#pragma once
// The torture set: small scenes and frames that reach the corner cases of the machine in lockstep. It has few
// configurations, so little RTL is built. Each draws many frames with different registers, memories, clocks
// and disturbance.
#include <string>
#include <vector>

#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// Frames that one machine draws in sequence.
struct TortureCase {
    std::string name;
    Job job;
    std::vector<Frame> frames;
    std::vector<Upload> uploads{};   ///< the host's writes before each frame; empty if there are none
    Disturbance disturbance;
    int seed = 1;   ///< seed of the RTL's registers before reset
};

/// The chips of the set. Each needs one module of RTL, so each covers as much as possible.
/// - `shading`: the engine that no other chip has, every unit, two pipelines, a shared cache, the shortest
///   queues;
/// - `wide`: boxes, the widest formats, fast timing;
/// - `sheared`: boxes, the other triangle test, one set in each cache;
/// - `homes`: two levels that shade, treelets above boxes, every interval at its longest but one, textures
///   with texels of 32 bits;
/// - `slants`: two levels, planes in any direction above globes, fast timing, no interval;
/// - `listed`: no tree, every unit that shades, fast timing with the longest interval, textures with texels
///   of 17 bits;
/// - `rays`: rays from memory, two pipelines, groups of four rays, bursts of two lines, fast timing.
const std::vector<std::string>& torture_chips();
Config torture_chip(const std::string& name);
std::vector<TortureCase> torture_cases(const std::string& chip);

/// Records the frames' rays, with the host's writes before each frame.
std::vector<RecordedFrame> record_torture(const TortureCase& torture);
/// Runs a case in lockstep.
LockstepResult run_torture(const TortureCase& torture, const Progress& progress = {});

}   // namespace rayclock
