#pragma once
// Notes about options that have no effect.
#include <string>
#include <vector>

#include "model/core/config.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/whitted.hpp"
#include "sim/run/request/finish.hpp"

namespace rayclock {

/// Returns a sentence for each key=value that changes nothing on this machine: "mem_latency has no effect
/// with dram=ddr3".
std::vector<std::string> ineffective_settings(const Config& config, const std::vector<std::string>& set);

/// Returns the same for the options of a finished picture of the scene.
std::vector<std::string> ineffective_finish(const Finish& finish, const Whitted& settings,
                                            const Scene& scene);

}   // namespace rayclock
