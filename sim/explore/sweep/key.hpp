#pragma once
// Digests for cache keys: everything except the configuration that affects figures.
#include <string>
#include <vector>

#include "model/scene/placed.hpp"

namespace rayclock::sweep {

/// Returns a digest of everything in a scene that affects its picture without motion, as 16 hexadecimal
/// digits.
std::string scene_digest(const Scene& scene);
/// Returns a digest that includes the pose of everything that moves at these times. Throws UserError as
/// pose() does.
std::string film_digest(PlacedScene scene, const std::vector<double>& times);

/// Returns a stamp of the compiler and of the sources that compute figures, made when the program was built.
/// So a changed program never uses cached figures of an older one.
const char* program_stamp();

}   // namespace rayclock::sweep
