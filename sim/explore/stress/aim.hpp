#pragma once
// Random rays for hard cases: origins, and directions to places where rounding decides.
#include "sim/explore/stress/families.hpp"

namespace rayclock::stress {

/// Returns the largest coordinate of N bits, or component of M bits.
inline std::int32_t most(int bits) { return (1 << (bits - 1)) - 1; }

/// The point of a triangle to aim at, as barycentric weights relative to their sum.
struct Weights {
    int a, b, c;
};
enum class Target { corner, edge, inside, any };
Weights weights(Target target, Rng& rng);

/// Returns a direction from o to a point of a triangle. It is exact, scaled by a random factor, if it fits in
/// M bits. Otherwise it is the nearest direction of full length.
Vec3i towards(const Vec3i& o, const oracle::Corners& t, const Weights& w, int dir_bits, Rng& rng);
/// The same for a lattice point.
Vec3i towards(const Vec3i& o, const Vec3i& point, int dir_bits, Rng& rng);

/// Returns any direction except zero.
Vec3i any_direction(int dir_bits, Rng& rng);
/// Returns a direction along an axis, forwards or backwards.
Vec3i axis_direction(int dir_bits, Rng& rng);

/// Returns a lattice point outside the mesh's bounds, near to them or anywhere.
Vec3i outside(const Mesh& mesh, int coord_bits, Rng& rng);

/// Returns half the size of a mesh: one of several scales from the whole lattice down to `least` lattice
/// steps.
double scale(int coord_bits, int least, Rng& rng);

}   // namespace rayclock::stress
