#pragma once
// Checks whole configurations.
#include <string>

#include "model/core/config.hpp"

namespace rayclock {

/// Throws UserError unless check_parameters() passes and, with levels=2, every node leaves room for the kind
/// of its line.
void check_config(const Config& config, const std::string& where);

}   // namespace rayclock
