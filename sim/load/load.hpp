#pragma once
#include <string>
#include <vector>

#include "model/base/progress.hpp"
#include "model/scene/builtin.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// SCENE of the command line: a built-in name with an optional size, or a file (.obj .ply .stl .off .3ds
/// .dae .glb .gltf, each also with .gz behind, .json). The result has passed check_scene(); the camera may be
/// absent. A file without a light gets two, except a JSON scene whose list of lights is empty. `primitives`
/// is the form of a built-in scene; a file decides for itself. What a file holds and is not drawn, or was
/// changed, is told in `notes`, a sentence each. Throws UserError.
Scene load_scene(const std::string& spec, const Progress& progress = {},
                 Primitives primitives = Primitives::triangles, std::vector<std::string>* notes = nullptr);

}   // namespace rayclock
