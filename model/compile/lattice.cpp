// Fits the lattice to a scene: bounds and pitches.
//
// The eye is a lattice point, because an error of the eye would move the whole picture. So the lattice is
// shifted by up to half a pitch. A vertex at the end of the bounds then lies at up to L + 1/2, L = 2^(N-1) -
// 1. It still goes to a point within half a pitch: to L, since snap() ends there.
//
// The machine's decisions do not change when each axis is scaled by a factor: sides of edges, order along a
// ray and ties stay the same. So an axis along which the scene is short has a finer pitch. It is at least
// half the coarsest pitch, because the directions' components grow in the same way. That takes up to a bit of
// M from the other axes, and of the range of t.
//
// Plain double arithmetic in a fixed order (-ffp-contract=off) gives the same points on every machine.
#include "model/compile/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/compile/plane.hpp"

namespace rayclock {

namespace {

constexpr double max_ratio = 2;

/// Returns a pitch, at least as large, that divides the first plane's sides on the lattice.
double with_planes(const Scene& scene, Lattice lattice, double pitch) {
    lattice.pitch = glm::dvec3(pitch);
    const double side =
        std::ldexp(glm::length(scene.planes[0].u), -plane_on_lattice(scene.planes[0], lattice).level[0]);
    return side / std::floor(side / pitch);
}

/// Returns the bounds of the scene, the eye, and the point of each plane that is nearest to their middle.
Bounds bounds_with(const Scene& scene, const glm::dvec3& eye) {
    Bounds box = bounds(scene);
    box = {glm::min(box.lo, eye), glm::max(box.hi, eye)};
    const glm::dvec3 middle = 0.5 * box.lo + 0.5 * box.hi;   // lo + hi might overflow
    for (const Plane& plane : scene.planes) {
        const glm::dvec3 point = nearest_point(plane, middle);
        box = {glm::min(box.lo, point), glm::max(box.hi, point)};
    }
    return box;
}

}   // namespace

Lattice fit_lattice(const Scene& scene, const glm::dvec3& eye, int coord_bits, bool cubic, double room) {
    const Bounds box = bounds_with(scene, eye);
    Lattice lattice;
    lattice.coord_bits = coord_bits;
    glm::dvec3 middle{0}, reach{0};
    for (int k = 0; k < 3; ++k) {
        middle[k] = 0.5 * box.lo[k] + 0.5 * box.hi[k];
        reach[k] = std::max(box.hi[k] - middle[k], middle[k] - box.lo[k]);
    }
    const double largest = largest_coordinate(coord_bits);
    double coarsest = room * std::max({reach.x, reach.y, reach.z}) / largest;
    if (!scene.planes.empty() && coarsest > 0) {
        lattice.centre = middle;
        coarsest = with_planes(scene, lattice, coarsest);
    }
    const double finest = cubic ? coarsest : coarsest / max_ratio;
    for (int k = 0; k < 3; ++k) {
        // If everything lies in one point, any pitch will do. Extents at the bottom of the format must not
        // give a pitch of zero.
        lattice.pitch[k] =
            coarsest > 0 ? std::max({reach[k] / largest, finest, std::numeric_limits<double>::min()}) : 1;
        lattice.centre[k] = eye[k] - lattice.pitch[k] * std::round((eye[k] - middle[k]) / lattice.pitch[k]);
    }
    return lattice;
}

}   // namespace rayclock
