#pragma once
// A mesh whose faces name their corners by number, as in PLY and OFF.
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/scene.hpp"
#include "sim/files/text.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// The vertices and faces of such a mesh.
struct IndexedMesh {
    /// A vertex with coordinates that are not finite. It is an error only if a face uses it.
    struct Fault {
        std::uint32_t vertex;
        std::uint64_t line;   ///< 0: the file has no lines
    };
    /// One position per vertex. `normals` is empty or has one entry per vertex.
    std::vector<glm::vec3> positions, normals;
    std::vector<std::uint32_t> indices;   ///< the corners of all faces; each is a valid vertex number
    std::vector<std::size_t> ends;   ///< end of each face in `indices`; a face has at least three corners
    /// Colours of the first vertices. A colour that is not finite counts as missing.
    std::vector<glm::vec3> colours;
    std::vector<glm::vec3> face_colours;   ///< the same for faces
    std::vector<Fault> faults;             ///< sorted by vertex
    bool has_normals = false;

    /// Ends a face: its corners are those since the end of the previous face.
    void end_face() { ends.push_back(indices.size()); }
};

/// Returns a scene with one part in one place. Its material is the default one or has the colours of faces or
/// vertices. Throws UserError if the mesh has no faces or a face uses a faulty vertex.
Scene scene_of(const IndexedMesh& mesh, const SourcePosition& at, Loading& loading, Warnings warnings);

}   // namespace rayclock
