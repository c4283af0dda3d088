#pragma once
// Checks of memory images that hold bounding spheres.
#include <string>

#include "model/layout/memory_image.hpp"

namespace rayclock {

/// Returns the faults of an image of globes, one sentence each. Requires that every globe contains all
/// corners and spheres below it, exactly. Every line of a node or primitive is reached once, kinds are in
/// order, and the report's nodes, leaves, depth and primitives are correct. Stops after 20 faults.
std::vector<std::string> check_globes(const MemoryImage& image, const Config& config);

/// The sizes of an image's globes relative to the smallest globes around their contents, as ratios of radii:
/// the enlargement by the lattice of a node.
struct GlobeSizes {
    std::uint64_t globes = 0;
    double mean = 0, most = 0;   ///< over globes with a size above 0
};
GlobeSizes globe_sizes(const MemoryImage& image, const Config& config);

}   // namespace rayclock
