// Building a scene from an indexed mesh.
#include "sim/load/mesh/indexed.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/load/mesh/mesh_file.hpp"

namespace rayclock {
namespace {

std::string sentence_of(const IndexedMesh& mesh, const IndexedMesh::Fault& fault) {
    const glm::vec3& p = mesh.positions[fault.vertex];
    const int axis = !std::isfinite(p.x) ? 0 : !std::isfinite(p.y) ? 1 : 2;
    return fmt::format("{}{} is {}, which is not a finite number that a 32-bit float can hold",
                       fault.line == 0 ? fmt::format("vertex {}: ", fault.vertex) : std::string(),
                       "xyz"[axis], p[axis]);
}

void check_vertices(const IndexedMesh& mesh, const SourcePosition& at, Warnings& warnings) {
    if (mesh.faults.empty()) return;
    const auto by_vertex = [](const IndexedMesh::Fault& fault, std::uint32_t i) { return fault.vertex < i; };
    for (const std::uint32_t i : mesh.indices) {
        const auto fault = std::lower_bound(mesh.faults.begin(), mesh.faults.end(), i, by_vertex);
        if (fault != mesh.faults.end() && fault->vertex == i)
            SourcePosition{at.file, fault->line}.refuse(sentence_of(mesh, *fault));
    }
    for (const IndexedMesh::Fault& fault : mesh.faults)
        warnings.count("unused vertex", "with coordinates that are not finite, left out", fault.line,
                       fault.line == 0 ? std::to_string(fault.vertex) : std::string());
}

/// Returns the colour with this number, or nothing if it is missing or not finite.
std::optional<glm::vec3> known(const std::vector<glm::vec3>& colours, std::size_t i) {
    if (i >= colours.size() || !std::isfinite(colours[i].r + colours[i].g + colours[i].b))
        return std::nullopt;
    return colours[i];
}

}   // namespace

Scene scene_of(const IndexedMesh& mesh, const SourcePosition& at, Loading& loading, Warnings warnings) {
    if (mesh.ends.empty()) at.refuse("the file has no triangles: all its faces are points or lines");
    check_vertices(mesh, at, warnings);
    Assembly assembly(at.file, loading);
    PartBuilder builder(mesh.ends.size(), mesh.has_normals);
    std::vector<Corner> corners;
    std::size_t k = 0;
    for (std::size_t face = 0; face < mesh.ends.size(); ++face) {
        FaceColour mean;
        for (corners.clear(); k < mesh.ends[face]; ++k) {
            const std::uint32_t i = mesh.indices[k];
            corners.push_back({glm::dvec3(mesh.positions[i]),
                               mesh.has_normals ? glm::dvec3(mesh.normals[i]) : glm::dvec3(0)});
            mean.add(known(mesh.colours, i));
        }
        std::optional<glm::vec3> colour = known(mesh.face_colours, face);
        if (!colour && mean.varies()) warnings.count("face", mixed_colours);
        if (!colour) colour = mean.mean();
        assembly.face(builder, corners, builder.colour(colour));
    }
    Material material{.name = "default"};
    if (!mesh.colours.empty() || !mesh.face_colours.empty()) material.colour = glm::dvec3(1);
    assembly.place(assembly.add(std::move(builder)), glm::dmat4(1), 0, [&] { return material; });
    Scene scene = assembly.take();
    warnings.say(loading);
    return scene;
}

}   // namespace rayclock
