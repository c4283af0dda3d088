// Scenes whose instances are not written out.
#include "model/scene/folded.hpp"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/base/error.hpp"
#include "model/scene/hit.hpp"

namespace rayclock {

Scene keep_instances(PlacedScene scene) {
    Scene own = scene.own;
    own.placed = std::make_shared<const PlacedScene>(std::move(scene));
    return own;
}

bool is_folded(const Scene& scene) {
    return scene.placed && !scene.placed->instances.empty() &&
           scene.triangles.size() == scene.placed->own.triangles.size();
}

std::uint64_t numbered_primitives(const Scene& scene) {
    return is_folded(scene) ? primitive_count(*scene.placed) : primitive_count(scene);
}

PlacedTriangle InstancedTriangles::operator()(std::uint32_t primitive) const {
    PlacedTriangle out;
    const auto take = [&](const auto& mesh, const Triangle& triangle) {
        out.is_smooth = !mesh.normals.empty();
        for (std::size_t k = 0; k < 3; ++k) {
            out.vertices[k] = mesh.vertices[triangle.vertex[k]];
            if (out.is_smooth) out.normals[k] = mesh.normals[triangle.vertex[k]];
        }
        out.material = triangle.material;
        if (!mesh.coordinates.empty())
            out.coordinates = mesh.coordinates[std::size_t(&triangle - mesh.triangles.data())];
    };
    if (primitive < scene_.own.triangles.size()) {
        take(scene_.own, scene_.own.triangles[primitive]);
        return out;
    }
    const std::uint32_t number = instances_.of(primitive);
    const Instance& instance = scene_.instances.at(number);
    const SharedMesh& mesh = scene_.meshes[instance.mesh];
    take(mesh, mesh.triangles.at(primitive - instances_.first(number)));
    if (instance.material) out.material = *instance.material;
    const glm::dmat3 linear(instance.place);
    const bool is_mirrored = glm::determinant(linear) < 0;
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    for (glm::dvec3& vertex : out.vertices) vertex = glm::dvec3(instance.place * glm::dvec4(vertex, 1));
    for (glm::dvec3& normal : out.normals) {
        const glm::dvec3 turned = unit_or_zero((is_mirrored ? -1.0 : 1.0) * (cofactors * normal));
        if (turned != glm::dvec3(0)) normal = turned;
    }
    if (is_mirrored) {
        std::swap(out.vertices[1], out.vertices[2]), std::swap(out.normals[1], out.normals[2]);
        std::swap(out.coordinates[1], out.coordinates[2]);
    }
    return out;
}

void check_folded(const Scene& scene, const std::string& where) {
    const PlacedScene& placed = *scene.placed;
    const std::uint64_t count = primitive_count(placed);
    if (count >= no_primitive)
        throw UserError(where + ": " + std::to_string(count) + " primitives are too many; the most is " +
                        std::to_string(no_primitive - 1));
    if (!scene.camera)
        throw UserError(where + ": " + std::to_string(count) +
                        " placed triangles are too many to find a camera for them; the scene must have one");
    if (!placed.motion.empty())
        throw UserError(where + ": " + std::to_string(count) +
                        " placed triangles are too many for a scene that moves");
    const auto check = [&](const auto& mesh) {
        Scene alone;
        alone.vertices = mesh.vertices, alone.normals = mesh.normals, alone.triangles = mesh.triangles;
        alone.coordinates = mesh.coordinates, alone.textures = placed.own.textures;
        alone.materials = placed.own.materials, alone.lights = placed.own.lights, alone.camera = scene.camera;
        check_scene(alone, where);
    };
    if (!placed.own.triangles.empty()) check(placed.own);
    for (const SharedMesh& mesh : placed.meshes) check(mesh);
}

}   // namespace rayclock
