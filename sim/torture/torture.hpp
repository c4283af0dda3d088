#pragma once
// The torture set: small scenes and frames that no user draws, made to reach the corners of the machine in
// lockstep. Few configurations, so that little RTL is built; on each, many frames with other registers,
// memories, clocks and traffic.
#include <string>
#include <vector>

#include "sim/lockstep/lockstep.hpp"

namespace rayclock {

/// Frames that one machine makes one after the other.
struct TortureCase {
    std::string name;
    Job job;
    std::vector<Frame> frames;
    Traffic traffic;
    int seed = 1;   ///< of what the RTL's registers hold before reset
};

/// The chips that are tortured: `shading`, with every unit, two pipelines, a shared cache and the shortest
/// queues; `wide`, one pipeline and the widest formats; `sheared`, the other triangle test. Each needs one
/// module of RTL.
const std::vector<std::string>& torture_chips();
Config torture_chip(const std::string& name);
std::vector<TortureCase> torture_cases(const std::string& chip);

/// Runs a case in lockstep.
LockstepResult run_torture(const TortureCase& torture, const Progress& progress = {});

}   // namespace rayclock
