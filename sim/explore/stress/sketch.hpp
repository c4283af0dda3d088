#pragma once
// Drawings of the families of hard cases.
#include <string>

#include "sim/explore/stress/families.hpp"

namespace rayclock::stress {

/// Draws a family from its own generator as SVG: the surface with some rays, and an enlarged view of one hit.
/// Crossings are dots, filled where the ray enters.
std::string sketch(const Family& family);

}   // namespace rayclock::stress
