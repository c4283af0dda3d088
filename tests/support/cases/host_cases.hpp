#pragma once
// Chips whose registers are tested alone.
#include <string>

#include "model/core/config.hpp"

namespace rayclock::test {

/// "small", and "shaded", with two pipelines.
inline Config host_config(const std::string& name) {
    Config config = named_config("small");
    if (name == "small") return config;
    config.shading = 1;
    config.lights = 3;
    config.pipelines = 2;
    return config;
}

}   // namespace rayclock::test
