// The lattice of a scene: bounds, pitch, nearest point.
//
// Plain double arithmetic in a fixed order (-ffp-contract=off): the same points on every machine.
#include <algorithm>
#include <cmath>
#include <limits>

#include "model/accel/memory_image.hpp"

namespace rayclock {

Lattice fit_lattice(const Scene& scene, const glm::dvec3& eye, int coord_bits) {
    const Bounds box = bounds(scene);
    Lattice lattice;
    lattice.coord_bits = coord_bits;
    double reach = 0;
    for (int k = 0; k < 3; ++k) {
        const double lo = std::min(box.lo[k], eye[k]), hi = std::max(box.hi[k], eye[k]);
        lattice.centre[k] = 0.5 * lo + 0.5 * hi;   // lo + hi might overflow
        // Taken as snap() computes it: the farthest vertex then divides to at most largest * (1 + 2^-51) and lands on it.
        reach = std::max({reach, hi - lattice.centre[k], lattice.centre[k] - lo});
    }
    const double largest = double((1 << (coord_bits - 1)) - 1);
    // Everything in one point: any pitch will do. Extents at the very bottom of the format must not give a pitch of zero.
    lattice.pitch = reach > 0 ? std::max(reach / largest, std::numeric_limits<double>::min()) : 1;
    return lattice;
}

Vec3i Lattice::snap(const glm::dvec3& point) const {
    const double largest = double((1 << (coord_bits - 1)) - 1);
    Vec3i snapped{};
    for (int k = 0; k < 3; ++k)
        snapped[std::size_t(k)] = std::int32_t(std::clamp(std::round((point[k] - centre[k]) / pitch), -largest, largest));
    return snapped;
}

} // namespace rayclock
