#pragma once
#include <string>

#include "model/scene/scene.hpp"

namespace rayclock {

/// What `--material` asks for: the name of a material of the built-in scene `spheres`, key=value pairs of the
/// JSON format with commas between them (a colour is 1:0.5:0), or a name and pairs. It replaces the material
/// of everything that has none of its own in its file. Throws UserError for what makes no sense, and if there
/// is nothing like that.
void give_material(Scene& scene, const std::string& typed);

/// Something has no material of its own.
bool may_give_material(const Scene& scene);

/// False if no ray can leave a primitive of the scene: all its materials neither reflect nor transmit.
bool has_bounces(const Scene& scene);

}   // namespace rayclock
