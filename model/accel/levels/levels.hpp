#pragma once
// Scene compilation in two levels: a tree over instances, and below it one for each mesh and class.
#include "model/accel/levels/maps.hpp"

namespace rayclock {

struct LevelsImage {
    MemoryImage image;   ///< line 0 is the root of the scene's tree; the lattice is the scene's
    LevelMaps maps;
    std::vector<std::uint32_t> roots;   ///< by class: line of its root, 0 if nothing is left of it
};

/// The configuration with levels=2. Throws UserError if no machine can be both.
Config with_two_levels(Config config, const std::string& where);

/// For that configuration. Throws UserError as it does, for a scene with true spheres or planes, and as
/// compile_scene() does.
LevelsImage compile_levels(const PlacedScene& scene, const glm::dvec3& eye, const Config& config);

}   // namespace rayclock
