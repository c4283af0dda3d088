#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sim/judge/reference/hierarchy.hpp"
#include "sim/judge/reference/ray.hpp"
#include "sim/judge/reference/round.hpp"
#include "sim/judge/reference/unit_space.hpp"

namespace rayclock {

/// What searching has taken, for measurements by one thread.
struct RefEffort {
    bool tests_all = false;    ///< no hierarchy: every primitive is tested, in order (a shadow ray stops at
                               ///< the first in its way)
    std::uint64_t rays = 0;    ///< of all kinds
    std::uint64_t boxes = 0;   ///< tested
    std::uint64_t tests = 0;   ///< of primitives, with those that fill up a leaf's last block
    double seconds = 0;        ///< in search, boxes and tests together
};

/// What the reference tracer makes of a scene's primitives: a hierarchy over the triangles, one over the
/// spheres, and the planes, which have no bounds and are tested by every ray.
class RefGeometry {
public:
    explicit RefGeometry(const Scene& scene);

    const RefUnitSpace& space() const { return space_; }

    /// From now on every search is measured and added to `effort`; nullptr: no longer. One thread only.
    void watch(RefEffort* effort) { effort_ = effort; }

    /// A ray from a point of the scene, in the tracer's space; false if a number is not finite or the
    /// direction is 0.
    bool find_path(const glm::dvec3& origin, const glm::dvec3& direction, RefPath& path) const;

    RefClosest closest(const RefPath& path) const {
        return effort_ ? watched(path, {}, 0) : closest(path, RefRay(path.from, path.direction));
    }

    /// Is there anything nearer than `distance`? Looks no further than the first thing that it finds.
    bool is_blocked(const RefPath& path, double distance) const;

    /// Where the path meets this primitive alone. Looks through all of them.
    RefClosest only(const RefPath& path, std::uint32_t primitive) const;

    /// All primitives that are nearer than `distance`, in no order.
    std::vector<std::uint32_t> blockers(const RefPath& path, double distance) const;

private:
    RefClosest closest(const RefPath& path, const RefRay& ray) const;
    template <class Effort> RefClosest closest_of_all(const RefPath& path, const RefRay& ray,
                                                      const RefClosest& limit, double enough,
                                                      Effort effort) const;
    template <class Effort> RefClosest closest_round(const RefPath& path, const RefRay& ray, RefClosest best,
                                                     double enough, Effort effort) const;
    RefClosest watched(const RefPath& path, const RefClosest& limit, double enough) const;
    RefClosest test_all(const RefPath& path, const RefRay& ray, RefClosest best, double enough) const;

    RefUnitSpace space_;
    std::vector<RefNode> nodes_, sphere_nodes_;
    std::vector<RefBlock> blocks_;
    std::vector<RefSphere> spheres_;   ///< in the order of the leaves, ref_block_size a block
    std::vector<RefPlane> planes_;
    RefEffort* effort_ = nullptr;
};

inline bool RefGeometry::find_path(const glm::dvec3& origin, const glm::dvec3& direction,
                                   RefPath& path) const {
    // Scaled by the largest component first: the square of a very short or long direction would not fit.
    const glm::dvec3 size = glm::abs(direction);
    const double largest = std::max(size.x, std::max(size.y, size.z));
    const bool has_direction = largest > 0 && std::isfinite(size.x + size.y + size.z);
    path.from = space_(origin);
    if (!has_direction || !std::isfinite(path.from.x + path.from.y + path.from.z)) return false;
    path.direction = glm::normalize(direction / largest);
    return true;
}

}   // namespace rayclock
