#pragma once
// Reads an image of planes in any direction and checks it.
#include <string>
#include <vector>

#include "model/layout/memory_image.hpp"

namespace rayclock {

/// Returns the faults of an image. Faults are lines that are reached twice or do not exist, counts that
/// differ from the report's, and points of `prims` that no leaf with the primitive contains. Tests 28 points
/// of a triangle, all whose barycentric coordinates are sixths, and the three corners of an infinite plane.
/// All computation is in whole numbers. Cells are closed, and the boxes of slants on the path must also
/// contain the point. Empty if there are no faults.
std::vector<std::string> check_slants(const MemoryImage& image, const std::vector<PrimData>& prims,
                                      const Config& config);

}   // namespace rayclock
