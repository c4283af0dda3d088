#pragma once
// The option --material, and questions about a scene's materials.
#include <string>

#include "model/scene/scene.hpp"

namespace rayclock {

/// Applies `--material` to the scene. `typed` is the name of a material of the built-in scene `spheres`, or
/// key=value pairs, or a name and pairs. Pairs have the keys of the JSON format and commas between them; a
/// colour is 1:0.5:0. It sets the material of all surfaces without one in their file. Throws UserError if
/// `typed` is wrong, or if every surface has a material.
void give_material(Scene& scene, const std::string& typed);

/// Returns true if some surface has no material.
bool may_give_material(const Scene& scene);

/// Returns false if no ray can leave a primitive: no material reflects or transmits.
bool has_bounces(const Scene& scene);

}   // namespace rayclock
