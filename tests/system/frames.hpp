#pragma once
// What the system tests share: scenes made ready, the four configurations whose RTL the quick tests build, and the
// demand that model and RTL agree.
#include <string>
#include <utility>
#include <vector>

#include "sim/lockstep/lockstep.hpp"

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
Config with(Config config, const std::vector<std::pair<std::string, int>>& values);

/// default, small, and two that lie far from both: `narrow` (12 bits, binary nodes, queues of two, least precision
/// everywhere) and `broad` (20 bits, most precision everywhere, two rays at a time).
Config quick_config(const std::string& name);
const std::vector<std::string>& quick_configs();

/// Runs a frame in lockstep and checks that the machines agree in every value, every cycle and every account.
LockstepResult check_lockstep(const Job& job, Traffic traffic = {}, int seed = 1);

} // namespace rayclock::test
