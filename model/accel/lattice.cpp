// The lattice of a scene: bounds, pitches, nearest point.
//
// The eye is a lattice point: what it is off would move the whole picture. To get there the lattice is shifted by up to half a
// pitch, so a vertex at the end of the bounds lies at up to L + 1/2, L = 2^(N-1) - 1, and still goes to a point within half a
// pitch: to L, since snap() ends there.
//
// What the machine decides does not change under a map of each axis by a factor: sides of edges, order along a ray and ties
// are the same. So an axis along which the scene is short has a finer pitch; no finer than half the coarsest, because the
// directions' components grow alike, which takes up to a bit of M from the other axes and of the range of t.
//
// Plain double arithmetic in a fixed order (-ffp-contract=off): the same points on every machine.
#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "model/accel/memory_image.hpp"

namespace rayclock {

namespace {

constexpr double most_ratio = 2;
/// With planes the lattice is so many times as large as what has an end: larger shows more of a floor, smaller more of the rest.
/// `spheres` against the reference, 256x192: 16: 41.0 dB, 32: 41.7, 64: 39.2.
constexpr double room_around = 32;

/// A pitch, at least as large, of which the first plane's squares are whole multiples.
double with_planes(const Scene& scene, double pitch) {
    const double side = glm::length(scene.planes[0].u), steps = std::floor(side / pitch);
    return steps >= 4 ? side / steps : pitch;
}

double largest_coordinate(int coord_bits) { return double((1 << (coord_bits - 1)) - 1); }

} // namespace

Lattice fit_lattice(const Scene& scene, const glm::dvec3& eye, int coord_bits, bool cubic) {
    const Bounds box = bounds(scene);
    Lattice lattice;
    lattice.coord_bits = coord_bits;
    glm::dvec3 middle{0}, reach{0};
    for (int k = 0; k < 3; ++k) {
        const double lo = std::min(box.lo[k], eye[k]), hi = std::max(box.hi[k], eye[k]);
        middle[k] = 0.5 * lo + 0.5 * hi;   // lo + hi might overflow
        reach[k] = std::max(hi - middle[k], middle[k] - lo);
    }
    const double largest = largest_coordinate(coord_bits);
    double coarsest = std::max({reach.x, reach.y, reach.z}) / largest;
    if (!scene.planes.empty()) coarsest = with_planes(scene, room_around * coarsest);
    const double finest = cubic ? coarsest : coarsest / most_ratio;
    for (int k = 0; k < 3; ++k) {
        // Everything in one point: any pitch will do. Extents at the very bottom of the format must not give a pitch of zero.
        lattice.pitch[k] = coarsest > 0 ? std::max({reach[k] / largest, finest, std::numeric_limits<double>::min()}) : 1;
        lattice.centre[k] = eye[k] - lattice.pitch[k] * std::round((eye[k] - middle[k]) / lattice.pitch[k]);
    }
    return lattice;
}

double Lattice::coarsest() const { return std::max({pitch.x, pitch.y, pitch.z}); }

Vec3i Lattice::snap(const glm::dvec3& point) const {
    const double largest = largest_coordinate(coord_bits);
    Vec3i snapped{};
    for (int k = 0; k < 3; ++k)
        snapped[std::size_t(k)] = std::int32_t(std::clamp(std::round((point[k] - centre[k]) / pitch[k]), -largest, largest));
    return snapped;
}

} // namespace rayclock
