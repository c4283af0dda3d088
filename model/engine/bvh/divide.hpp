#pragma once
// One step of building a tree of boxes: which of them go to the left.
#include <span>

#include "model/layout/tree.hpp"

namespace rayclock {

struct BoxItem {
    LatticeBox box;
    std::uint32_t index = 0;   ///< what the box is of
};

constexpr std::size_t parallel_from = 4096;   // boxes: smaller subtrees are not worth a task
constexpr int max_sah_depth = 64;             // below, halves: at most 24 more levels

/// Puts those that go to the left first, and returns how many they are. `centres` is around all centres,
/// twice as large as the lattice (LatticeBox::centre).
std::size_t divide(std::span<BoxItem> part, const LatticeBox& centres, int depth);

}   // namespace rayclock
