#pragma once
// Textures of loaded scenes: decodes pictures to mip levels, and completes the coordinates of all triangles
// in the last step of a load.
#include <memory>
#include <string>

#include "sim/load/loading.hpp"

namespace rayclock {

/// Returns the sentence that explains why a triangle cannot be drawn with a texture, or an empty string.
/// `corners`: the coordinates as in the file.
std::string coordinate_fault(const Texture& texture, const CornerCoordinates& corners);

/// Decodes a picture and makes its levels. Returns null, with the reason in `why`, if it cannot be read.
/// Resamples sides to powers of two; adds a note if the limit shrinks a side. `file` names the scene in
/// notes, `name` the picture. Throws UserError if the picture exceeds the allowance.
std::shared_ptr<const Pyramid> read_pyramid(const std::string& bytes, const std::string& file,
                                            const std::string& name, Loading& loading, std::string& why);

/// Completes the textures of a loaded scene. Shifts the coordinates of each textured triangle close to 0.
/// Triangles without coordinates get the average colour of their texture. Spheres get octahedral pictures.
/// Removes all coordinates and textures that no primitive shows, for example if the load averages textures.
/// `where` begins the notes. Throws UserError if the coordinates of a triangle span too much.
void settle_textures(PlacedScene& scene, const std::string& where, Loading& loading);

}   // namespace rayclock
