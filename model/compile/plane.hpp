#pragma once
// An infinite plane on the lattice.
#include "model/layout/memory_image.hpp"

namespace rayclock {

/// A point a of the plane and two sides b - a, c - a, between which u and v of a hit count. Sides are those
/// of the checkers' squares, halved or doubled until they are between a 32nd and a 16th of what the lattice
/// reaches: so whatever a square's size is, u and v reach at least half of 2^light_reach times as far as the
/// lattice. By how much rounding turns the plane is proven in docs/verdict.md. a is as near to the lattice's
/// middle as whole sides from the plane's own point allow.
struct PlaneOnLattice {
    Vec3i a{}, b{}, c{};
    std::array<int, 2> level{};   ///< a square's u is 2^level[0] (b - a), its v 2^level[1] (c - a)
    std::array<double, 2> at{};   ///< whole sides from the plane's point to a
};
PlaneOnLattice plane_on_lattice(const Plane& plane, const Lattice& lattice);

/// The same plane for whoever counts squares from the plane's point, in lattice steps.
Plane snapped_plane(const Plane& plane, const Lattice& lattice);

/// The point of the plane that is nearest to `from`, by the largest of the three coordinates' distances.
glm::dvec3 nearest_point(const Plane& plane, const glm::dvec3& from);

/// Where its squares begin; if they are too small for u and v to tell, or one is larger than all that they
/// can say, the surface gets the one colour that is seen.
void set_checkers(const PlaneOnLattice& plane, const Config& config, Surface& surface);

/// How many times as large as what has an end the lattice is in a scene with planes: room for
/// Config::approach_shift()'s steps. Where one of several planes transmits or mirrors, rays go on from it to
/// the others, beyond what a point can say (ShadeState::lost): the lattice is horizon_room times as large
/// then.
double room_around_planes(const Scene& scene, const Config& config);
constexpr double horizon_room = 4;

}   // namespace rayclock
