#pragma once
// Fits the lattice to a scene.
#include "model/layout/lattice.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// Returns a lattice with a point at the eye. `cubic`: the same pitch along all axes, as spheres and
/// shading require. A plane counts with its point nearest to the middle of the other primitives. With planes
/// the lattice is `room` times as large as necessary, and the squares of the first plane are a whole number
/// of pitches.
Lattice fit_lattice(const Scene& scene, const glm::dvec3& eye, int coord_bits, bool cubic = false,
                    double room = 1);

}   // namespace rayclock
