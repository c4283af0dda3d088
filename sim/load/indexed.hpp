// A mesh whose faces name their corners by number, as PLY and OFF have it.
#pragma once
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/scene.hpp"
#include "sim/files/text.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

struct IndexedMesh {
    std::vector<glm::vec3> positions, normals;   ///< of vertices; either no normals, or one of each
    std::vector<std::uint32_t> indices;          ///< of all faces' corners; each names a vertex
    std::vector<std::size_t> ends;               ///< of each face, in `indices`; a face has three corners
    bool has_normals = false;

    /// The corners from the last face's end on are a face.
    void end_face() { ends.push_back(indices.size()); }
};

/// One part in one place, of the default material. Refuses a mesh without faces.
Scene scene_of(const IndexedMesh& mesh, const Place& at, Loading& loading);

}   // namespace rayclock
