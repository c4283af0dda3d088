#pragma once
// A memory image read back: for tests, for exact checkers, for whoever wants to see what the chip sees.
//
// Nothing here is taken on trust: a damaged image gives complaints, not undefined behaviour.
// (for_each_node and for_each_triangle, however, ask for an image that check_image finds sound.)
#include <functional>
#include <string>
#include <vector>

#include "model/layout/memory_image.hpp"

namespace rayclock {

Node read_node(const MemoryImage& image, std::uint32_t line, const Config& config);
PrimData read_triangle(const MemoryImage& image, std::uint32_t half_line, const Config& config);

/// Every node from the one in `root` down, depth first: f(node, the number of its inner children, that of its
/// triangles). Inner children lie at the node's base, and triangles behind them.
void for_each_node(const MemoryImage& image, std::uint32_t root, const Config& config,
                   const std::function<void(const Node&, std::uint32_t inner, std::uint32_t triangles)>& f);

/// Every triangle, in depth-first order of the tree.
void for_each_triangle(const MemoryImage& image, const Config& config,
                       const std::function<void(const PrimData&)>& f);

/// What is wrong with an image, one sentence each; empty if nothing is. Every child's dequantised box holds
/// all triangles below it; every line is reached once, blocks do not overlap, and what nothing uses is zero;
/// kinds are in order; the report's figures are true. With the scene: its triangles, snapped, are there
/// exactly once, except for those without area (sheared: with two equal corners). Stops after 20 complaints.
std::vector<std::string> check_image(const MemoryImage& image, const Config& config,
                                     const Scene* scene = nullptr);

}   // namespace rayclock
