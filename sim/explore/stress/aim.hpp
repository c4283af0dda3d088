#pragma once
// Rays of the hard cases: origins, and directions to places where rounding decides.
#include "sim/explore/stress/families.hpp"

namespace rayclock::stress {

/// Largest coordinate of N bits, or component of M bits.
inline std::int32_t most(int bits) { return (1 << (bits - 1)) - 1; }

/// Where to aim: the point of a triangle with these weights over their sum.
struct Weights {
    int a, b, c;
};
enum class Target { corner, edge, inside, any };
Weights weights(Target target, Rng& rng);

/// Direction from o to a point of a triangle: exactly along it, times a random factor, where that fits M
/// bits; the nearest direction of full length where it does not.
Vec3i towards(const Vec3i& o, const oracle::Corners& t, const Weights& w, int dir_bits, Rng& rng);
/// The same to a lattice point.
Vec3i towards(const Vec3i& o, const Vec3i& point, int dir_bits, Rng& rng);

/// Any direction but zero.
Vec3i any_direction(int dir_bits, Rng& rng);
/// Along an axis, forwards or backwards.
Vec3i axis_direction(int dir_bits, Rng& rng);

/// A lattice point outside the mesh's bounds: anywhere, or near.
Vec3i outside(const Mesh& mesh, int coord_bits, Rng& rng);

/// A half size for a mesh, one of several scales: from the whole lattice down to `least` lattice steps.
double scale(int coord_bits, int least, Rng& rng);

}   // namespace rayclock::stress
