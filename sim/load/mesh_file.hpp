// A mesh file of another program (.obj .ply .stl .glb .gltf) as a scene.
#pragma once
#include <filesystem>

#include "model/core/progress.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

bool is_mesh_file(const std::filesystem::path& path);

/// Triangles in the order of the file, materials in use, camera and lights if the file has them. Throws UserError.
Scene load_mesh_file(const std::filesystem::path& path, const Progress& progress);

} // namespace rayclock
