#pragma once
// Scenes of so many placed triangles that nobody writes them out: their instances stay as they are. A machine
// of two levels walks them, and the reference moves its rays into them, in double precision.
#include "model/scene/placed.hpp"

namespace rayclock {

/// More placed triangles than this stay folded.
constexpr std::uint64_t most_unfolded = 100'000'000;

/// The scene with its own triangles alone, and the instances in `placed`.
Scene folded(PlacedScene scene);
/// Whether the scene has instances that are not written out.
bool is_folded(const Scene& scene);
/// Of all primitives, as they are numbered: those of instances as well.
std::uint64_t numbered_primitives(const Scene& scene);

/// Of these, the triangles.
inline std::uint64_t triangle_count(const Scene& scene) {
    return numbered_primitives(scene) - scene.spheres.size() - scene.planes.size();
}

/// One triangle as it would stand in the flat scene.
struct PlacedTriangle {
    std::array<glm::dvec3, 3> vertices{};
    std::array<glm::dvec3, 3> normals{};   ///< unit; 0 if the scene has none
    bool is_smooth = false;
    std::uint32_t material = 0;
};

/// Finds triangles of a folded scene by their numbers. The scene must stay.
class Unfolder {
public:
    explicit Unfolder(const PlacedScene& scene);
    PlacedTriangle operator()(std::uint32_t primitive) const;

private:
    const PlacedScene& scene_;
    std::vector<std::uint64_t> firsts_;   ///< of the instances
};

/// Throws UserError unless a folded scene can be drawn: as check_scene(), mesh by mesh; and it must have a
/// camera, since finding one needs all triangles.
void check_folded(const Scene& scene, const std::string& where);

}   // namespace rayclock
