#pragma once
// Textures of loaded scenes: from the bytes of a picture to its levels, and the last step of a load, which
// settles the coordinates of all triangles.
#include <memory>
#include <string>

#include "sim/load/loading.hpp"

namespace rayclock {

/// The largest |s| and |t| that a file may give. Beyond it, a 32-bit float keeps too few digits of a texel.
constexpr double most_given_coordinate = 1e6;

/// Returns the sentence that explains why a triangle cannot be drawn with a texture, or an empty string. The
/// coordinates are those of the file.
std::string coordinate_fault(const Texture& texture, const CornerCoordinates& corners);

/// Decodes a picture and makes its levels. Returns null, with the reason in `why`, if it cannot be read.
/// Resamples sides that are no powers of two; adds a note if a side shrinks. `file` names the scene in notes,
/// `name` the picture. Throws UserError if the picture exceeds the allowance.
std::shared_ptr<const Pyramid> read_pyramid(const std::string& bytes, const std::string& file,
                                            const std::string& name, Loading& loading, std::string& why);

/// Settles the textures of a loaded scene. Shifts the coordinates of each textured triangle around 0. Gives
/// primitives that cannot show their texture its average colour: triangles without coordinates, spheres and
/// planes. Leaves no coordinates and no textures if no triangle shows one. If the load averages textures, no
/// triangle does. `where` begins the notes. Throws UserError if the coordinates of a triangle span too much.
void settle_textures(PlacedScene& scene, const std::string& where, Loading& loading);

}   // namespace rayclock
