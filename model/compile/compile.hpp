#pragma once
// Scene compilation: the scene on the lattice, its tree, and the bytes of the chip's memory.
#include <string>
#include <vector>

#include "model/base/progress.hpp"
#include "model/layout/memory_image.hpp"
#include "model/layout/tree.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// Snaps the scene to the lattice, builds a wide SAH tree, quantises outward and lays out the image. The
/// bytes are the same on every machine and for every number of threads. Throws UserError if nothing is left
/// on the lattice. It also throws if the configuration has too few address bits, bits of primitive numbers or
/// stack places. `room`: with one level, the lattice's size in units of its least size.
MemoryImage compile_scene(const Scene& scene, const glm::dvec3& eye, const Config& config,
                          const Progress& progress = {}, double room = 1);
/// Compiles triangles that are already on the lattice, and for which counts() is true. The image's lattice
/// keeps its default.
/// Throws UserError as compile_scene does.
MemoryImage compile_triangles(const std::vector<PrimData>& triangles, const Config& config,
                              const std::string& name, const Progress& progress = {});

/// Returns false for a primitive that the image omits: a sphere without radius, or a triangle without area.
/// With the sheared test a triangle without area stays unless two corners coincide, because rounding its
/// corners may give it area that its neighbour loses.
bool counts(const PrimData& triangle, const Config& config);

// ---- Parts of compile_scene() that the compilers of two levels and of deforming meshes also use.

/// Returns the box of a sphere or plane within the lattice. A plane fills the lattice.
LatticeBox box_of(const PrimData& prim, int coord_bits);

/// Returns the boxes of primitives, in their order, as a tree of boxes stores them.
std::vector<LatticeBox> boxes_of(const std::vector<PrimData>& prims, const Config& config);

/// Throws UserError if `kept`, the primitives that the lattice keeps, is empty or has too many.
void check_kept(const std::vector<PrimData>& kept, const Scene& scene, const Config& config,
                const std::string& name);

/// Throws UserError if the configuration's stack cannot hold `need` groups of siblings.
void check_stack(int need, const Config& config, const std::string& name);

}   // namespace rayclock
