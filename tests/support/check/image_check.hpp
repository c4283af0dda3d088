#pragma once
// Checks a memory image from its bytes alone: a damaged image gives complaints, never undefined behaviour.
#include <string>
#include <vector>

#include "model/layout/decode.hpp"

namespace rayclock {

/// What is wrong with an image, one sentence each; empty if nothing is. Every child's dequantised box holds
/// all triangles below it; every line is reached once, blocks do not overlap, and what nothing uses is zero;
/// kinds are in order; the report's figures are true. With the scene: its triangles, snapped, are there
/// exactly once, except for those without area (sheared: with two equal corners). Stops after 20 complaints.
std::vector<std::string> check_image(const MemoryImage& image, const Config& config,
                                     const Scene* scene = nullptr);

}   // namespace rayclock
