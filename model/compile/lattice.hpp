#pragma once
// Fits the lattice to a scene.
#include "model/layout/lattice.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// Returns a lattice with a point at the eye. `cubic`: the same pitch along all axes, as spheres and
/// shading require. A plane counts with its point nearest to the middle of the other primitives. The lattice
/// is `room` times as large as necessary. The squares of the first plane are a whole number of pitches.
Lattice fit_lattice(const Scene& scene, const glm::dvec3& eye, int coord_bits, bool cubic = false,
                    double room = 1);

/// Steps between the border of a stream's lattice and all spheres in it. Nodes do not reach beyond the
/// lattice, so a ray along the border would miss a sphere that does. A sphere moves outward by less than 2
/// steps: half a step each by the shift of the lattice and by its centre's rounding, and less than a third of
/// a step by its radius's.
constexpr double sphere_margin = 3;

}   // namespace rayclock
