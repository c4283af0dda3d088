#pragma once
#include "model/core/config.hpp"

namespace rayclock {

/// The configuration with what depends on other parameters: origin_bits at most as wide as the other widths
/// allow, and no panes or horizon where check_config() refuses them.
Config settled(Config config);

}   // namespace rayclock
