#pragma once
#include <string>

#include "sim/explore/stress/families.hpp"

namespace rayclock::stress {

/// A family as an SVG picture, from its own generator: the surface with some of its rays, and the place where
/// one of them hits, enlarged. Crossings are dots, filled where the ray enters.
std::string sketch(const Family& family);

}   // namespace rayclock::stress
