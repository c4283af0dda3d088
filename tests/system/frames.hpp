#pragma once
// What the system tests share: scenes made ready, the four configurations whose RTL the quick tests build,
// and the demand that model and RTL agree.
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

/// Like make_shot, with the stack that the scene needs if the configuration's is too small.
Shot make_deep_shot(const std::string& scene, FrameSize size, Config config);

/// A configuration with some parameters changed; must be legal.
Config with(const Config& config, const Values& values);

/// default, small, and two that lie far from both: `narrow` (12 bits, binary nodes, queues of two, least
/// precision everywhere; two pipelines that take pixels row by row and share a cache, long lines, DDR3) and
/// `broad` (20 bits, most precision everywhere; one ray at a time, caches of one line, ideal memory).
Config quick_config(const std::string& name);
const std::vector<std::string>& quick_configs();

/// Runs a frame in lockstep and checks that the machines agree in every value, every cycle and every account.
LockstepResult check_lockstep(const Job& job, Traffic traffic = {}, int seed = 1);
/// The same with several frames on one machine; the result is the last one's.
LockstepResult check_lockstep(const Job& job, const std::vector<FrameTrace>& frames, Traffic traffic = {},
                              int seed = 1);

}   // namespace rayclock::test
