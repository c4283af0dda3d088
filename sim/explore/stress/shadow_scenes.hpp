#pragma once
// Meshes on the lattice that are difficult for the origins of secondary rays.
#include <functional>
#include <string>
#include <vector>

#include "sim/judge/oracle/cross.hpp"

namespace rayclock {

/// A mesh by name.
struct ShadowScene {
    std::string name;
    std::string what;
    /// Returns the mesh for coordinates of N bits. All surfaces are closed except the floor.
    std::function<std::vector<oracle::Corners>(int coord_bits)> make;
};
const std::vector<ShadowScene>& shadow_scenes();

}   // namespace rayclock
