#pragma once
// Scenes with too many placed triangles to write out. Their instances stay as they are. A machine of two
// levels walks them, and the reference moves its rays into them, in double precision.
#include "model/scene/placed.hpp"

namespace rayclock {

/// A scene with more placed triangles stays folded.
constexpr std::uint64_t max_unfolded = 100'000'000;

/// Returns the scene with only its own triangles, and the instances in `placed`.
Scene keep_instances(PlacedScene scene);
/// True if the scene has instances that are not written out.
bool is_folded(const Scene& scene);
/// Returns the number of all primitives, including those of instances.
std::uint64_t numbered_primitives(const Scene& scene);

/// Returns the number of triangles among these.
inline std::uint64_t triangle_count(const Scene& scene) {
    return numbered_primitives(scene) - scene.spheres.size() - scene.planes.size();
}

/// One triangle as it would be in the flat scene.
struct PlacedTriangle {
    std::array<glm::dvec3, 3> vertices{};
    std::array<glm::dvec3, 3> normals{};   ///< unit vectors; 0 if the scene has none
    CornerCoordinates coordinates{};       ///< 0 if the mesh has none
    bool is_smooth = false;
    std::uint32_t material = 0;
};

/// Finds triangles of a folded scene by their numbers. The scene must outlive it.
class InstancedTriangles {
public:
    explicit InstancedTriangles(const PlacedScene& scene) : scene_(scene), instances_(scene) {}
    PlacedTriangle operator()(std::uint32_t primitive) const;

private:
    const PlacedScene& scene_;
    InstanceNumbers instances_;
};

/// Throws UserError unless a folded scene can be drawn. It checks each mesh as check_scene() does. The scene
/// must have a camera, since finding one needs all triangles.
void check_folded(const Scene& scene, const std::string& where);

}   // namespace rayclock
