#pragma once
// The reference tracer's search for hits: its hierarchies, and the closest hit and shadow queries.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sim/judge/reference/hierarchy.hpp"
#include "sim/judge/reference/ray.hpp"
#include "sim/judge/reference/round.hpp"
#include "sim/judge/reference/unit_space.hpp"

namespace rayclock {

/// The cost of searches, for measurements on one thread.
struct RefEffort {
    /// Test every primitive in order, without a hierarchy. A shadow ray stops at its first blocker.
    bool tests_all = false;
    std::uint64_t rays = 0;    ///< of all kinds
    std::uint64_t boxes = 0;   ///< tested boxes
    std::uint64_t tests = 0;   ///< tested primitives, including those that pad a leaf's last block
    double seconds = 0;        ///< of searches: boxes and tests together
};

/// The reference tracer's form of a scene: a hierarchy over the triangles, one over the spheres, and the
/// planes. Planes have no bounds, so every ray tests them.
class RefGeometry {
public:
    explicit RefGeometry(const Scene& scene);

    const RefUnitSpace& space() const { return space_; }

    /// Adds the cost of every search from now on to `effort`; nullptr stops this. Use it on one thread only.
    void watch(RefEffort* effort) { effort_ = effort; }

    /// Converts a ray from a point of the scene to the tracer's space. Returns false if a number is not
    /// finite or the direction is 0.
    bool find_path(const glm::dvec3& origin, const glm::dvec3& direction, RefPath& path) const;

    /// Returns the closest hit, or no_primitive.
    RefClosest closest(const RefPath& path) const {
        return effort_ ? watched(path, {}, 0) : closest(path, RefRay(path.from, path.direction));
    }

    /// Returns true if anything is nearer than `distance`. Stops at the first blocker.
    bool is_blocked(const RefPath& path, double distance) const;

    /// Returns where the path meets one primitive, regardless of all others. Searches all primitives for it.
    RefClosest only(const RefPath& path, std::uint32_t primitive) const;

    /// Returns the hit of each primitive that is nearer than `distance`, in arbitrary order. Ends with the
    /// first hit for which is_last(hit) is true.
    std::vector<RefClosest> hits_before(const RefPath& path, double distance,
                                        const std::function<bool(const RefClosest&)>& is_last = {}) const;
    /// Returns the primitives of these hits.
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
    std::vector<RefSphere> spheres_;   ///< in the order of the leaves, ref_block_size per block
    std::vector<RefPlane> planes_;
    RefEffort* effort_ = nullptr;
};

inline bool RefGeometry::find_path(const glm::dvec3& origin, const glm::dvec3& direction,
                                   RefPath& path) const {
    // Divide by the largest component first: the square of a very short or long direction would not fit a
    // double.
    const glm::dvec3 size = glm::abs(direction);
    const double largest = std::max(size.x, std::max(size.y, size.z));
    const bool has_direction = largest > 0 && std::isfinite(size.x + size.y + size.z);
    path.from = space_(origin);
    if (!has_direction || !std::isfinite(path.from.x + path.from.y + path.from.z)) return false;
    path.direction = glm::normalize(direction / largest);
    return true;
}

}   // namespace rayclock
