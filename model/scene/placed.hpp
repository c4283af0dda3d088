#pragma once
// A scene that places meshes without copying them. The machine's second level walks it; everything else gets
// a flat scene (docs/machine/motion.md).
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "model/scene/builtin.hpp"
#include "model/scene/motion.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// Triangles that any number of instances share, in their own space.
struct SharedMesh {
    std::string name;
    std::vector<glm::dvec3> vertices;
    std::vector<glm::dvec3> normals;                ///< as in Scene
    std::vector<Triangle> triangles;                ///< with the scene's materials
    std::vector<CornerCoordinates> coordinates{};   ///< as in Scene
};

/// A mesh in its place.
struct Instance {
    std::string name;         ///< for messages
    std::uint32_t mesh = 0;   ///< index in PlacedScene::meshes
    glm::dmat4 place{1};      ///< from the mesh's space to the scene's; the last row is 0 0 0 1
    std::optional<std::uint32_t> material;   ///< of all its triangles; without it each keeps its own
};

/// A scene with instances in addition to its own primitives. A graph of any depth is reduced to one level of
/// instances. Primitives are numbered as in the flat scene: triangles of the scene itself, then those of each
/// instance in turn, then spheres and planes.
struct PlacedScene {
    Scene own;
    std::vector<SharedMesh> meshes;
    std::vector<Instance> instances;
    Motion motion{};   ///< instances, camera and lights hold the state of one of its times
};

/// Returns the number of primitives of the flat scene.
std::uint64_t primitive_count(const PlacedScene& scene);

/// Finds the instance of a primitive by its number.
class InstanceNumbers {
public:
    explicit InstanceNumbers(const PlacedScene& scene);
    /// Returns the index in PlacedScene::instances; `none` for the scene's own primitives and unknown
    /// numbers.
    std::uint32_t of(std::uint64_t primitive) const;
    static constexpr std::uint32_t none = 0xffff'ffffu;
    /// Returns the number of the instance's first primitive.
    std::uint64_t first(std::uint32_t instance) const { return firsts_[instance]; }

private:
    std::vector<std::uint64_t> firsts_;   ///< of the instances, then the number after the last one
};

/// Returns the scene with every instance as triangles. Without instances and motion it is the scene itself.
/// Throws UserError beyond 2^32 - 1 vertices.
Scene flattened(PlacedScene scene);
/// Returns the same triangles, without a copy of the placed scene.
Scene flat_copy(const PlacedScene& scene);

/// Appends the part's primitives moved by `place`, which must keep angles if there are spheres. A mirror
/// image is turned inside out again; normals follow the inverse transpose. All primitives get `material`, or
/// the part's own plus `material_base`. Both scenes must have normals or neither, unless `scene` is still
/// empty. If only one of them has texture coordinates, the other gets coordinates of 0. The caller appends
/// materials and textures. Throws UserError beyond 2^32 - 1 vertices.
void append(Scene& scene, const Scene& part, const glm::dmat4& place, std::optional<std::uint32_t> material,
            std::uint32_t material_base);

/// Returns the unit vector, or 0 for a vector without a direction.
glm::dvec3 unit_or_zero(glm::dvec3 v);

/// Returns a built-in scene with its instances, if it has some. make_builtin() returns the same scene,
/// flattened.
PlacedScene make_placed(std::string_view spec, Primitives primitives = Primitives::triangles);

}   // namespace rayclock
