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
/// on the lattice. It also throws if the image needs more lines, the scene longer primitive numbers, or the
/// tree a deeper stack than the configuration has.
MemoryImage compile_scene(const Scene& scene, const glm::dvec3& eye, const Config& config,
                          const Progress& progress = {});
/// Compiles triangles that are already on the lattice and count. The image's lattice keeps its default.
/// Throws UserError as compile_scene does.
MemoryImage compile_triangles(const std::vector<PrimData>& triangles, const Config& config,
                              const std::string& name, const Progress& progress = {});

/// True if a triangle can be hit, or another triangle may rely on it. A triangle without area cannot, except
/// with the sheared test: rounding its corners may give it area that its neighbour loses.
bool counts(const PrimData& triangle, const Config& config);

// ---- Its parts, which the compilers of two levels and of deforming meshes also use.

/// Returns the box of a sphere or plane within the lattice. A plane fills the lattice.
LatticeBox box_of(const PrimData& prim, int coord_bits);

/// Returns the boxes of primitives, in their order, as a tree of boxes holds them.
std::vector<LatticeBox> boxes_of(const std::vector<PrimData>& prims, const Config& config);

/// Throws UserError if the lattice keeps nothing of the scene in `kept`, or if there are too many primitives.
void check_kept(const std::vector<PrimData>& kept, const Scene& scene, const Config& config,
                const std::string& name);

/// Throws UserError if the configuration's stack cannot hold `need` groups of siblings.
void check_stack(int need, const Config& config, const std::string& name);

}   // namespace rayclock
