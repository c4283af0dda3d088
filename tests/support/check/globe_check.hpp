#pragma once
#include <string>

#include "model/layout/memory_image.hpp"

namespace rayclock {

/// What is wrong with an image of globes, one sentence each; empty if nothing is. Every globe holds all
/// corners and spheres below it, exactly; every line of a node or primitive is reached once; kinds are in
/// order; and the report's nodes, leaves, depth and primitives are true. Stops after 20 complaints.
std::vector<std::string> check_globes(const MemoryImage& image, const Config& config);

/// How much larger the globes of an image are than the least ones around what they hold, as ratios of radii:
/// what the lattice of a node adds.
struct GlobeSizes {
    std::uint64_t globes = 0;
    double mean = 0, most = 0;   ///< over globes that have a size
};
GlobeSizes globe_sizes(const MemoryImage& image, const Config& config);

}   // namespace rayclock
