#pragma once
// Configurations for tests of the host's registers alone.
#include <string>

#include "model/core/config.hpp"

namespace rayclock::test {

/// Returns "small", or "shaded", which has two pipelines.
inline Config host_config(const std::string& name) {
    Config config = named_config("small");
    if (name == "small") return config;
    config.shading = 1;
    config.lights = 3;
    config.pipelines = 2;
    return config;
}

}   // namespace rayclock::test
