#pragma once
// Reads an image of planes in any direction back.
#include <string>
#include <vector>

#include "model/layout/memory_image.hpp"

namespace rayclock {

/// What is wrong with an image: lines that are reached twice or do not exist, counts that differ from the
/// report's, and points of `prims` that no leaf with their primitive holds. Of a triangle 28 points are
/// tried, all whose barycentric coordinates are sixths; of an infinite plane its three corners. All in whole
/// numbers: cells are closed, and the boxes of slants on the way must hold the point as well. Empty if
/// nothing is wrong.
std::vector<std::string> check_slants(const MemoryImage& image, const std::vector<PrimData>& prims,
                                      const Config& config);

}   // namespace rayclock
