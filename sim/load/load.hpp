#pragma once
// Loading any scene that the command line can name.
#include <string>
#include <vector>

#include "model/base/progress.hpp"
#include "model/scene/builtin.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// How to draw pictures on surfaces: on triangles with coordinates, or in their average colour everywhere.
enum class Textures : std::uint8_t { drawn, averaged };

/// Loads the SCENE of the command line: a built-in name with an optional size, or a file. Files are .json, or
/// .obj .ply .stl .off .3ds .dae .glb .gltf and the formats of Assimp, each also with .gz. The result has
/// passed check_scene(); it may lack a camera. A file without lights gets two, except a JSON scene whose list
/// of lights is empty. `primitives` is the form of a built-in scene and does not affect files. `notes`
/// receives one sentence for each kind of content that is changed or not drawn. Throws UserError.
Scene load_scene(const std::string& spec, const Progress& progress = {},
                 Primitives primitives = Primitives::triangles, std::vector<std::string>* notes = nullptr,
                 Textures textures = Textures::drawn);

}   // namespace rayclock
