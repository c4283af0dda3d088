#pragma once
// The surfaces of all primitives, which a chip that shades reads in addition to the tree, and its registers.
#include <optional>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/whitted.hpp"

namespace rayclock {

/// Returns the scene with the corners of its large triangles moved slightly. They move to lattice points
/// whose coordinates differ by multiples of up to 2^max_fine. On each axis a corner moves by at most 2^-14
/// of the shortest edge of its triangles, and by at most 2^-13 at the end of the lattice. Secondary rays from
/// such triangles then begin closer to the hit point. The result is empty if there are no large triangles.
std::optional<Scene> align_large_triangles(const Scene& scene, const Lattice& lattice);

/// Returns primitive number i on the lattice.
PrimData snap_primitive(const Scene& scene, const Lattice& lattice, std::size_t i);

/// Changes the kind of some triangles to cut-out, if the chip has textures: of those whose material has a
/// texture and a cut-off. PrimData::prim is an index into `triangles`.
void mark_cutouts(const std::vector<Triangle>& triangles, const std::vector<CornerCoordinates>& coordinates,
                  const std::vector<Material>& materials, const Config& config, std::vector<PrimData>& prims);

/// Removes each sphere with the centre and radius of an earlier one, and returns how many it removed. The
/// machine excludes the sphere that a ray leaves by its number, so the ray would meet the other one there
/// (docs/proofs/who-checks-the-rules.md, Two spheres at one place).
std::size_t drop_coincident_spheres(std::vector<PrimData>& prims);

/// Returns the surface of primitive number i: the primitive itself, corner normals if the scene has some,
/// turned to the triangle's side, and the material.
Surface surface_of(const Scene& scene, const Lattice& lattice, const Config& config, std::size_t i);

/// Throws UserError if the scene needs a unit that the configuration does not have.
void check_units(const Scene& scene, const Config& config, const std::string& name);

/// Appends the surfaces, a line each, to the image. `records`: the result of write_records(). Throws
/// UserError beyond the address range.
void write_surfaces(const Scene& scene, const std::vector<std::uint32_t>& records, const Config& config,
                    const std::string& name, MemoryImage& image);

/// Returns the shading registers of a frame of this height. Throws UserError if the configuration has too few
/// lights or bounces, or only one sample.
ShadeFrame make_shade_frame(const Scene& scene, const Whitted& settings, const MemoryImage& image,
                            std::uint32_t height, const Config& config);

/// Returns the configuration with exactly the optional units that the scene and the picture need.
Config fitted_config(const Scene& scene, const Whitted& settings, Config config);

}   // namespace rayclock
