#pragma once
#include <memory>
#include <vector>

#include <glm/mat3x3.hpp>

#include "sim/judge/reference/geometry.hpp"
#include "model/scene/placed.hpp"

namespace rayclock {

/// The reference tracer on instances that are not written out: a hierarchy over their boxes, and one for each
/// mesh. A ray is moved into an instance's space in double precision by the inverse of its place; nothing of
/// the chip's maps is known here.
class RefInstances {
public:
    explicit RefInstances(const PlacedScene& scene);

    /// As Reference::trace().
    Hit trace(const glm::dvec3& origin, const glm::dvec3& direction) const;

private:
    struct Placed {
        glm::dmat3 back{1};     ///< from the scene's directions to the mesh's
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
