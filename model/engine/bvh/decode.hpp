#pragma once
// Reads a memory image back. for_each_node and for_each_primitive require an image that check_image
// (tests/support/check/image_check.hpp) finds sound.
#include <functional>

#include "model/engine/bvh/node.hpp"
#include "model/layout/memory_image.hpp"

namespace rayclock::bvh {

Node read_node(const MemoryImage& image, std::uint32_t line, const Config& config);

/// Calls f(node, number of its inner children, number of its primitives) for every node from `root` down,
/// depth first. Inner children lie at the node's base, its primitives behind them.
void for_each_node(const MemoryImage& image, std::uint32_t root, const Config& config,
                   const std::function<void(const Node&, std::uint32_t inner, std::uint32_t primitives)>& f);

/// Calls f for every primitive, in depth-first order of the tree.
void for_each_primitive(const MemoryImage& image, const Config& config,
                        const std::function<void(const PrimData&)>& f);

}   // namespace rayclock::bvh
