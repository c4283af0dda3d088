#pragma once
// The reference tracer's hierarchies of instances and meshes.
#include <memory>
#include <vector>

#include <glm/mat3x3.hpp>

#include "model/scene/placed.hpp"
#include "sim/judge/reference/geometry.hpp"

namespace rayclock {

/// The reference tracer for folded scenes, whose instances are not expanded: a hierarchy over the boxes of
/// the instances, and one for each mesh. It moves a ray into an instance's space in double precision by the
/// inverse of its place. It shares nothing with the chip's maps.
class RefInstances {
public:
    explicit RefInstances(const PlacedScene& scene);

    /// Returns the closest hit, as Reference::trace() does.
    Hit trace(const glm::dvec3& origin, const glm::dvec3& direction) const;

private:
    struct Placed {
        glm::dmat3 back{1};     ///< maps directions of the scene to directions of the mesh
        glm::dvec3 origin{0};   ///< the mesh's origin in the scene
        std::uint32_t mesh = 0, first = 0;
        bool is_mirrored = false;
    };
    void add(const glm::dmat4& place, std::uint32_t mesh, std::uint64_t first);
    void test(const Placed& placed, const glm::dvec3& origin, const glm::dvec3& direction,
              RefClosest& best) const;

    std::vector<RefGeometry> meshes_;
    std::vector<Bounds> bounds_;   ///< of the meshes
    std::vector<Placed> placed_;
    RefUnitSpace space_;
    std::vector<RefNode> nodes_;
    std::vector<std::uint32_t> order_;
};

}   // namespace rayclock
