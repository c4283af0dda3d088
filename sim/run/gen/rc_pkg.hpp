#pragma once
// The generator of the RTL's package.
#include <string>

#include "model/core/config.hpp"

namespace rayclock {

/// Returns the text of rc_pkg.sv for a configuration. It has the constants, and every payload of
/// model/core/payloads.hpp as a packed struct with the same fields in the same order. Arrays become flat
/// vectors with element 0 in the lowest bits.
std::string rc_package(const Config& config);

}   // namespace rayclock
