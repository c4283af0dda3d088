#include "sim/load/indexed.hpp"

#include "sim/load/mesh_file.hpp"

namespace rayclock {

Scene scene_of(const IndexedMesh& mesh, const Place& at, Loading& loading) {
    if (mesh.ends.empty()) at.refuse("the file has no triangles: all its faces are points or lines");
    Assembly assembly(at.file, loading);
    PartBuilder builder(mesh.ends.size(), mesh.has_normals);
    std::vector<Corner> corners;
    std::size_t k = 0;
    for (const std::size_t end : mesh.ends) {
        for (corners.clear(); k < end; ++k) {
            const std::uint32_t i = mesh.indices[k];
            corners.push_back({glm::dvec3(mesh.positions[i]),
                               mesh.has_normals ? glm::dvec3(mesh.normals[i]) : glm::dvec3(0)});
        }
        assembly.face(builder, corners);
    }
    assembly.place(assembly.add(std::move(builder)), glm::dmat4(1), 0,
                   [] { return Material{.name = "default"}; });
    return assembly.take();
}

}   // namespace rayclock
