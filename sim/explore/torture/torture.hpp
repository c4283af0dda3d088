#pragma once
// The torture set: small scenes and frames that no user draws, made to reach the corners of the machine in
// lockstep. Few configurations, so that little RTL is built; on each, many frames with other registers,
// memories, clocks and traffic.
#include <string>
#include <vector>

#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// Frames that one machine makes one after the other.
struct TortureCase {
    std::string name;
    Job job;
    std::vector<Frame> frames;
    std::vector<Upload> uploads{};   ///< what the host writes before each frame; none if it writes nothing
    Traffic traffic;
    int seed = 1;   ///< of what the RTL's registers hold before reset
};

/// The chips that are tortured. Each needs one module of RTL, so each covers what it can.
/// - `shading`: the engine that no other chip has, every unit, two pipelines, a shared cache, the shortest
///   queues;
/// - `wide`: boxes, the widest formats, fast timing;
/// - `sheared`: boxes, the other triangle test, one set in each cache;
/// - `homes`: two levels that shade, treelets above boxes, every interval at its longest but one;
/// - `slants`: two levels, planes in any direction above globes, fast timing, no interval;
/// - `listed`: no tree, every unit that shades, fast timing with the longest interval.
const std::vector<std::string>& torture_chips();
Config torture_chip(const std::string& name);
std::vector<TortureCase> torture_cases(const std::string& chip);

/// The frames' rays, with what the host writes before each.
std::vector<RecordedFrame> record_torture(const TortureCase& torture);
/// Runs a case in lockstep.
LockstepResult run_torture(const TortureCase& torture, const Progress& progress = {});

}   // namespace rayclock
