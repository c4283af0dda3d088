#pragma once
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

/// A sentence for each key=value that changes nothing on this machine: "mem_latency has no effect with
/// dram=ddr3".
std::vector<std::string> idle_settings(const Config& config, const std::vector<std::string>& set);

}   // namespace rayclock
