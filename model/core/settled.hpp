#pragma once
// Dependent parameters, adjusted to the others.
#include "model/core/config.hpp"

namespace rayclock {

/// Returns the configuration with its dependent parameters adjusted. origin_bits is at most as wide as the
/// other widths allow; panes and horizon are 0 where check_config() refuses them.
Config settled(Config config);

}   // namespace rayclock
