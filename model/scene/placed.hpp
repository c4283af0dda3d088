// A scene that places meshes without copying them: what the second level of the machine walks, and what
// everything else gets as a flat scene (docs/motion.md).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "model/scene/builtin.hpp"
#include "model/scene/motion.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// Triangles that any number of instances share, in a space of their own.
struct SharedMesh {
    std::string name;
    std::vector<glm::dvec3> vertices;
    std::vector<glm::dvec3> normals;   ///< as in Scene
    std::vector<Triangle> triangles;   ///< their materials are the scene's
};

/// A mesh in its place.
struct Instance {
    std::string name;         ///< in sentences
    std::uint32_t mesh = 0;   ///< index in PlacedScene::meshes
    glm::dmat4 place{1};      ///< from the mesh's space to the scene's; the last row is 0 0 0 1
    std::optional<std::uint32_t> material;   ///< of all its triangles; else each has its own
};

/// A scene, and instances beside its own primitives. A graph of any depth has become one level of instances
/// here. Primitives are numbered as in the flat scene: triangles of the scene itself, then those of each
/// instance in turn, then spheres and planes.
struct PlacedScene {
    Scene own;
    std::vector<SharedMesh> meshes;
    std::vector<Instance> instances;
    Motion motion{};   ///< instances, camera and lights are where they are at one of its times
};

/// Of the flat scene.
std::uint64_t primitive_count(const PlacedScene& scene);

/// Every instance becomes triangles. Without instances and motion, the scene itself. Throws UserError if they
/// are more than a vertex number can tell.
Scene flattened(PlacedScene scene);
/// The same triangles, without what was written out to make them.
Scene flat_copy(const PlacedScene& scene);

/// Appends the part's primitives moved by `place`, which must keep angles if there are spheres. A mirror
/// image is turned inside out again; normals go by the inverse transpose. Materials: `material` for all, or
/// the part's own plus `material_base`. Both must have normals or both none, unless `scene` is still empty.
void append(Scene& scene, const Scene& part, const glm::dmat4& place, std::optional<std::uint32_t> material,
            std::uint32_t material_base);

/// The unit vector, or 0 for a vector without a direction.
glm::dvec3 unit_or_zero(glm::dvec3 v);

/// A built-in scene with its instances, if it is made of some: make_builtin() is this one, flattened.
PlacedScene make_placed(std::string_view spec, Primitives primitives = Primitives::triangles);

}   // namespace rayclock
