#pragma once
// Checks a memory image from its bytes alone. A damaged image gives complaints, never undefined behaviour.
#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "model/engine/bvh/decode.hpp"

namespace rayclock {

/// Returns the faults of an image, one sentence each. Every child's dequantised box contains all triangles
/// below it. Every line is reached once, blocks do not overlap, and unused lines are zero. Kinds are in
/// order, and the report's figures are correct. With the scene, its snapped triangles must each be there
/// exactly once, except those without area (sheared: with two equal corners). Stops after 20 faults.
std::vector<std::string> check_image(const MemoryImage& image, const Config& config,
                                     const Scene* scene = nullptr);

}   // namespace rayclock
