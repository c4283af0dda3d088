#pragma once
// Meshes on the lattice that are hard on the origins of secondary rays.
#include <functional>
#include <string>
#include <vector>

#include "sim/judge/oracle/cross.hpp"

namespace rayclock {

struct ShadowScene {
    std::string name;
    std::string what;
    /// For coordinates of N bits. All surfaces are closed except for the floor.
    std::function<std::vector<oracle::Corners>(int coord_bits)> make;
};
const std::vector<ShadowScene>& shadow_scenes();

}   // namespace rayclock
