#pragma once
// Quantisation of globes in a node.
#include "model/engine/spheres/enclose.hpp"
#include "model/engine/spheres/node.hpp"

namespace rayclock::spheres {

/// A child of a node to be written: its globe, and its number of primitives (0: an inner child). Inner
/// children come first.
struct GlobeChild {
    Globe globe;
    std::uint32_t primitives = 0;
};

/// Returns the node that holds the children. It rounds centres to the nearest step of 2^exp. It adds the
/// centre's shift to the radius and rounds that up, so the written globe contains the exact one. exp is the
/// least with which all fit.
GlobeNode encode_globes(std::span<const GlobeChild> children, std::uint32_t base, const Config& config);

}   // namespace rayclock::spheres
