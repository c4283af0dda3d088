#pragma once
// Shared by the system tests: prepared scenes, the four configurations whose RTL the quick tests build, and
// the check that model and RTL agree.
#include <string>
#include <utility>
#include <vector>

#include "sim/run/lockstep/lockstep.hpp"
#include "tests/support/machine/machines.hpp"

namespace rayclock::test {

/// A scene with its camera, compiled for one picture on one configuration.
struct Shot {
    Scene scene;
    Job job;
};
Shot make_shot(const std::string& scene, FrameSize size, const Config& config);

/// Works like make_shot(), and deepens the stack if the scene needs it.
Shot make_deep_shot(const std::string& scene, FrameSize size, Config config);

/// Returns a configuration with some parameters changed; the result must be legal.
Config with(const Config& config, const Values& values);

/// Returns default, small, or one of two extremes. `narrow` has 12 bits, binary nodes, queues of two and
/// least precision everywhere; two pipelines that process pixels row by row and share a cache, long lines and
/// DDR3. `broad` has 20 bits and most precision everywhere; one ray at a time, caches of one line and ideal
/// memory.
Config quick_config(const std::string& name);
const std::vector<std::string>& quick_configs();

/// Runs a frame in lockstep. Requires that the machines agree in every value, every cycle and every account.
LockstepResult check_lockstep(const Job& job, Disturbance disturbance = {}, int seed = 1);
/// Runs several frames on one machine and returns the last result.
LockstepResult check_lockstep(const Job& job, const std::vector<RecordedFrame>& frames,
                              Disturbance disturbance = {}, int seed = 1);

}   // namespace rayclock::test
