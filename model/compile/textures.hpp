#pragma once
// Textures in the memory image: texels, and the record of each textured primitive.
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/scene/scene.hpp"
#include "model/unit/tex/texel.hpp"

namespace rayclock {

/// Returns the texture record of a primitive that shows a texture. `base`: the first line of its texels. A
/// sphere's corners are (0, 0), (1, 0) and (0, 1): its u and v are a place in the octahedral picture. A plane
/// for which plane_coordinates() returns nothing has the texture's last level everywhere.
TexRecord record_of(const Scene& scene, const Lattice& lattice, const Config& config, std::size_t primitive,
                    std::uint32_t base);

/// The first lines of the textures that an image holds. Textures that differ only in their filter share
/// texels.
using TextureLines = std::map<std::tuple<const Pyramid*, Wrap, Wrap>, std::uint32_t>;

/// Appends the texels of all textures that primitives show to the image, except those in `known`. Does
/// nothing if the chip or the scene has no textures. Throws UserError beyond the address range.
void write_texels(const Scene& scene, const Config& config, const std::string& name, TextureLines& known,
                  MemoryImage& image);

/// Appends a record for each textured primitive, after write_texels(). `lattice`: the primitives' lattice.
/// Returns the line of each primitive's record, or 0 if the primitive shows no texture. Returns an empty list
/// if the chip or the scene has no textures. Throws UserError beyond the address range.
std::vector<std::uint32_t> write_records(const Scene& scene, const Lattice& lattice, const Config& config,
                                         const std::string& name, const TextureLines& known,
                                         MemoryImage& image);

/// Writes the records again, into the lines that write_records() returned.
void rewrite_records(const Scene& scene, const Lattice& lattice, const Config& config,
                     const TextureLines& known, const std::vector<std::uint32_t>& records,
                     MemoryImage& image);

/// Calls write_texels() and write_records(), for an image of one scene.
std::vector<std::uint32_t> write_textures(const Scene& scene, const Lattice& lattice, const Config& config,
                                          const std::string& name, MemoryImage& image);

/// Returns Placement::texel_scale for the entries of an instance's map.
std::int32_t texel_scale_of(const std::array<std::int32_t, 9>& a, const Config& config);

/// Returns ShadeFrame::spread for a picture of this height.
std::int32_t spread_of(const Camera& camera, std::uint32_t height, int samples_per_side);

}   // namespace rayclock
