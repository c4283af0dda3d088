#pragma once
// Why no width will do: the part of a scene that makes it large.
#include <optional>
#include <string>

#include "model/scene/scene.hpp"

namespace rayclock::fit {

/// A material's triangles, or the few largest triangles, without which the rest and the eye would lie closer
/// together.
struct Dominant {
    std::string what;   ///< "material 'ground' (2 triangles)", "triangle 12", "the 3 largest triangles (12
                        ///< first)"
    Scene without;      ///< the scene without them; primitives are numbered anew
    std::size_t triangles = 0;   ///< left out
    double ratio = 1;            ///< extent of the whole scene with its eye over that without them
};

/// The material whose triangles make the scene largest, or else its largest triangles; none if the extent
/// would not halve, or nothing would be left. `scene` must have a camera.
std::optional<Dominant> dominant_part(const Scene& scene);

}   // namespace rayclock::fit
