#pragma once
// An infinite plane on the lattice.
#include <optional>

#include "model/layout/memory_image.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// A point a of the plane and two sides b - a, c - a, which are the units of a hit's u and v. The sides are
/// those of the checkers' squares, halved or doubled until they lie between a 32nd and a 16th of the
/// lattice's reach. So u and v reach at least half of 2^light_reach times as far as the lattice, for every
/// size of a square. docs/proofs/who-checks-the-rules.md bounds the turn of the plane by rounding. a lies
/// whole sides from the plane's own point, as near as possible to the lattice's middle.
struct PlaneOnLattice {
    Vec3i a{}, b{}, c{};
    std::array<int, 2> level{};   ///< a square's u is 2^level[0] (b - a), its v 2^level[1] (c - a)
    std::array<double, 2> at{};   ///< whole sides from the plane's point to a
};
PlaneOnLattice plane_on_lattice(const Plane& plane, const Lattice& lattice);

/// Returns the coordinates of a texture at the corners a, b and c of a plane on the lattice, shifted by whole
/// periods as for triangles (near_zero()). Returns nothing if one of them exceeds max_coordinate. The
/// corners then span about 126 pictures or more, or the texture clamps and its picture lies far from a.
std::optional<CornerCoordinates> plane_coordinates(const Plane& plane, const PlaneOnLattice& on,
                                                   const Texture& texture);

/// Returns the plane on the lattice, in lattice steps, with squares counted from the plane's own point.
Plane snapped_plane(const Plane& plane, const Lattice& lattice);

/// Returns the point of the plane nearest to `from`, by the largest of the three coordinates' distances.
glm::dvec3 nearest_point(const Plane& plane, const glm::dvec3& from);

/// Sets the phase of the plane's squares. If they are too small for u and v, or one is larger than the range
/// of u and v, the surface gets the one colour that is visible.
void set_checkers(const PlaneOnLattice& plane, const Config& config, Surface& surface);

/// Returns the ratio of the lattice's size to that of the bounded primitives, in a scene with planes. It
/// leaves room for the steps of Config::approach_shift(). Where one of several planes transmits or mirrors,
/// rays continue from it to the others, beyond the range of a point (ShadeState::is_lost). The lattice is
/// then horizon_room times as large.
double room_around_planes(const Scene& scene, const Config& config);
constexpr double horizon_room = 4;

}   // namespace rayclock
