#pragma once
// The last step of compiling a tree: its nodes as memory lines.
//
// Blocks lie depth-first. A block is everything that a node's base points at: one line per inner child, then
// the leaves' triangles in half lines, padded to a line. A subtree is contiguous except for its root's line.
#include <functional>
#include <vector>

#include "model/engine/bvh/collapse.hpp"
#include "model/layout/memory_image.hpp"

namespace rayclock {

/// Writes words and the report's nodes, leaves, depth, stack_need and bytes. `triangles` are in the order of
/// the boxes over which the tree was built. Throws UserError beyond 2^addr_bits lines; `name` begins the
/// sentence.
void emit_boxes(const BinaryTree& tree, const std::vector<PrimData>& triangles, const Config& config,
                const std::string& name, MemoryImage& image);
/// Does the same, and gives each child the globe around everything below it (spheres/enclose.hpp).
void emit_globes(const BinaryTree& tree, const std::vector<PrimData>& prims, const Config& config,
                 const std::string& name, MemoryImage& image);

/// Do the same for space cut by planes (space_cells/build.hpp, octree/build.hpp), and for a plain list of all
/// primitives, from line 0 on.
void emit_cells(const std::vector<PrimData>& prims, const Config& config, const std::string& name,
                MemoryImage& image, const std::function<void()>& report);
void emit_list(const std::vector<PrimData>& prims, const Config& config, const std::string& name,
               MemoryImage& image);

/// Throws UserError if `lines` memory lines cannot be addressed.
void check_lines(std::uint64_t lines, const Config& config, const std::string& name);

}   // namespace rayclock
