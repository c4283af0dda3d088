#pragma once
// The children of a node, and the answer of every node unit.
#include "model/core/payloads.hpp"

namespace rayclock {

/// A node unpacked for the model: planes by axis, and the place of each child in the block. Inner children
/// come first.
struct alignas(32) WideNode {
    std::array<std::int32_t, 4> org{};   ///< the fourth entry is 0, here and in exp
    std::array<std::uint8_t, 4> exp{};
    std::uint32_t base = 0;
    std::uint8_t children = 0, children_mask = 0, inner_mask = 0;
    std::array<std::uint8_t, 2 * 3 * max_width> planes{};    ///< [(3 * hi + axis) * 8 + child]
    std::array<std::uint8_t, max_width> offset{}, count{};   ///< as in NodeAnswer
};

/// Returns the answer: the children that the ray meets, inner ones first, then leaves, both nearest first.
NodeAnswer node_answer(std::uint32_t ray, std::uint32_t hits, const std::uint32_t* t_near,
                       const WideNode& node);

}   // namespace rayclock
