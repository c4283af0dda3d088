#pragma once
// What figures depend on beside the configuration, for the keys under which they are kept.
#include <string>
#include <vector>

#include "model/scene/placed.hpp"

namespace rayclock::sweep {

/// Everything of a scene that a picture of it at rest depends on, as 16 hexadecimal digits.
std::string scene_digest(const Scene& scene);
/// Of everything that moves, where it is at these times. Throws UserError as pose() does.
std::string film_digest(PlacedScene scene, const std::vector<double>& times);

/// Of the sources that figures come from and of the compiler, taken when the program was built: a changed
/// program finds nothing of an older one's.
const char* program_stamp();

}   // namespace rayclock::sweep
