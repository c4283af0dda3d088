#pragma once
// Explains why no width is enough: finds the part of a scene that makes it large.
#include <optional>
#include <string>

#include "model/scene/scene.hpp"

namespace rayclock::fit {

/// The triangles of a material, or the few largest triangles. Without them the scene and the eye have a
/// smaller extent.
struct Dominant {
    /// Such as "material 'ground' (2 triangles)", "triangle 12", "the 3 largest triangles (12 first)".
    std::string what;
    Scene without;               ///< the scene without them; its primitives are renumbered
    std::size_t triangles = 0;   ///< number of removed triangles
    double ratio = 1;            ///< extent of the whole scene with its eye, over the extent without them
};

/// Returns the material whose triangles enlarge the scene most, or else its largest triangles. Returns
/// nothing unless their removal halves the extent and leaves a triangle. `scene` must have a camera.
std::optional<Dominant> dominant_part(const Scene& scene);

}   // namespace rayclock::fit
