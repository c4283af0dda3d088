#pragma once
// How much work a frame is, without a clock: the machine's walk through the tree, ray by ray, by the same
// pure functions.
#include <cstdint>

#include "model/accel/memory_image.hpp"

namespace rayclock {

struct WorkCount {
    std::uint64_t rays = 0, hits = 0;
    std::uint64_t nodes = 0;       ///< visited, the root too
    std::uint64_t triangles = 0;   ///< tested
    std::size_t stack = 0;         ///< most sibling groups that a ray kept
};

/// Every `step`-th pixel across and down, from pixel (step / 2, step / 2) on. A node's leaves come before its
/// inner children, nearest first, as model/list and model/bvh have it.
WorkCount count_work(const MemoryImage& image, const Frame& frame, const Config& config, int step = 1);

}   // namespace rayclock
