#pragma once
#include <string>

#include "model/core/config.hpp"

namespace rayclock {

/// The text of rc_pkg.sv for a configuration: its constants, and every payload of model/core/payloads.hpp as
/// a packed struct with the same fields in the same order. Arrays become flat vectors with element 0 at the
/// bottom.
std::string rc_package(const Config& config);

}   // namespace rayclock
