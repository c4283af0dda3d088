#pragma once
// Textures in the memory image: texels, and the record of each textured triangle.
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/scene/scene.hpp"
#include "model/unit/tex/texel.hpp"

namespace rayclock {

/// Returns the texture record of a triangle whose material has a texture. `base`: the first line of its
/// texels.
TexRecord record_of(const Scene& scene, const Lattice& lattice, const Config& config, std::uint32_t triangle,
                    std::uint32_t base);

/// Appends the texels of all textures that triangles use to the image, then a record for each triangle that
/// has one. Returns the line of each triangle's record, 0 without a texture; empty if there is none. Throws
/// UserError beyond the address range.
std::vector<std::uint32_t> write_textures(const Scene& scene, const Config& config, const std::string& name,
                                          MemoryImage& image);

/// Returns ShadeFrame::spread for a picture of this height.
std::int32_t spread_of(const Camera& camera, std::uint32_t height, int samples_per_side);

}   // namespace rayclock
