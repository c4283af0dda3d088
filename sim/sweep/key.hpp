#pragma once
// What figures depend on beside the configuration, for the keys under which they are kept.
#include <string>

#include "model/scene/scene.hpp"

namespace rayclock::sweep {

/// Everything of a scene that a picture depends on, as 16 hexadecimal digits.
std::string scene_digest(const Scene& scene);

/// Of the sources that figures come from and of the compiler, taken when the program was built: a changed
/// program finds nothing of an older one's.
const char* program_stamp();

}   // namespace rayclock::sweep
