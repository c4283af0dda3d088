#pragma once
// One step of building a tree of boxes: the choice of the boxes that go to the left.
#include <span>

#include "model/layout/tree.hpp"

namespace rayclock::bvh {

struct BoxItem {
    LatticeBox box;
    std::uint32_t index = 0;   ///< number of the primitive or instance in the box
};

constexpr std::size_t parallel_from = 4096;   // boxes; smaller subtrees are not worth a task
constexpr int max_sah_depth = 64;             // deeper levels halve: at most 24 more levels

/// Moves the boxes of the left side to the front and returns their number. `centres` bounds all centres, in
/// half lattice steps (LatticeBox::centre).
std::size_t divide(std::span<BoxItem> part, const LatticeBox& centres, int depth);

}   // namespace rayclock::bvh
