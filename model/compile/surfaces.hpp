#pragma once
// What a chip that shades finds in memory beside the tree: every primitive's surface.
#include <optional>

#include "model/layout/memory_image.hpp"
#include "model/layout/tree.hpp"

namespace rayclock {

/// The scene with the corners of its large triangles moved a little, at lattice points of which all three
/// coordinates' differences are multiples of up to 2^most_fine: a corner moves by 2^-15 of the shortest edge
/// that ends there, at most. Secondary rays from there then begin the nearer to where the ray hit. Nothing if
/// there are no large triangles.
std::optional<Scene> aligned(const Scene& scene, const Lattice& lattice);

/// Primitive number i on the lattice.
PrimData snap_primitive(const Scene& scene, const Lattice& lattice, std::size_t i);

/// Of a sphere or plane: a box in the lattice. A plane is everywhere.
LatticeBox box_of(const PrimData& prim, int coord_bits);

/// Its surface: the primitive again, corner normals if the scene has some and they lie on the triangle's
/// side, the material.
Surface surface_of(const Scene& scene, const Lattice& lattice, const Config& config, std::size_t i);

/// Throws UserError if the scene needs a unit that the configuration does not have.
void check_units(const Scene& scene, const Config& config, const std::string& name);

/// Appends the surfaces, a line each, to the image. Throws UserError beyond what can be addressed.
void write_surfaces(const Scene& scene, const Config& config, const std::string& name, MemoryImage& image);

}   // namespace rayclock
