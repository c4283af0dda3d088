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
    /// A vertex with coordinates that are not finite: a fault only where a face uses it.
    struct Fault {
        std::uint32_t vertex;
        std::uint64_t line;   ///< 0: none
    };
    std::vector<glm::vec3> positions, normals;   ///< of vertices; either no normals, or one of each
    std::vector<std::uint32_t> indices;          ///< of all faces' corners; each names a vertex
    std::vector<std::size_t> ends;               ///< of each face, in `indices`; a face has three corners
    std::vector<glm::vec3> colours;              ///< of the first vertices; one that is not finite is none
    std::vector<glm::vec3> face_colours;         ///< the same of faces
    std::vector<Fault> faults;                   ///< by vertex
    bool has_normals = false;

    /// The corners from the last face's end on are a face.
    void end_face() { ends.push_back(indices.size()); }
};

/// One part in one place, of the default material or of the colours of faces or vertices. Refuses a mesh
/// without faces, and one whose faces use a vertex with a fault.
Scene scene_of(const IndexedMesh& mesh, const Place& at, Loading& loading, Warnings warnings);

}   // namespace rayclock
