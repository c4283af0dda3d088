#pragma once
// Checks whole configurations.
#include <string>

#include "model/core/config.hpp"

namespace rayclock {

/// Throws UserError unless every parameter and every combination is legal, and every node fits its line.
void check_config(const Config& config, const std::string& where);

}   // namespace rayclock
