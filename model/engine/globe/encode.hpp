#pragma once
#include "model/engine/globe/enclose.hpp"

namespace rayclock {

/// Children of a node to be, inner ones first: globes, and how many primitives (0: an inner child).
struct GlobeChild {
    Globe globe;
    std::uint32_t primitives = 0;
};

/// Centres to the nearest step of 2^exp, radii up, after what the centre has moved is added: the globe that
/// is written holds the real one. exp is the least with which all fit.
GlobeNode encode_globes(std::span<const GlobeChild> children, std::uint32_t base, const Config& config);

}   // namespace rayclock
