#pragma once
// The lattice on which the machine holds a scene.
#include <glm/vec3.hpp>

#include "model/core/payloads.hpp"

namespace rayclock {

/// The lattice of N-bit signed coordinates that covers the scene's bounds and the eye: point = centre + pitch
/// * k.
struct Lattice {
    glm::dvec3 centre{0};
    glm::dvec3 pitch{1};   ///< scene units per lattice step, for each axis; none is more than twice another
    int coord_bits = 18;
    double coarsest() const;   ///< the largest pitch
    /// Returns a direction of the scene in lattice steps, in units of the coarsest pitch: d / pitch *
    /// coarsest().
    glm::dvec3 direction(const glm::dvec3& d) const { return d * (coarsest() / pitch); }
    Vec3i snap(const glm::dvec3& point) const;   ///< nearest lattice point, halves away from zero
};

/// Returns the largest coordinate of N bits, 2^(N-1) - 1. The lattice leaves out the least one.
inline double largest_coordinate(int coord_bits) { return double((1 << (coord_bits - 1)) - 1); }

}   // namespace rayclock
