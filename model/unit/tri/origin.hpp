#pragma once
// Origins of secondary rays, exactly on the surface, so that rays need no epsilon. docs/proofs/origins.md has
// the proofs.
//
// The point O lies strictly inside the triangle that was hit, exactly in its plane, and has B fraction bits.
// From there every decision is exact, as for camera rays. The triangle itself and all triangles in its plane
// have num = 0, and t > 0 excludes them; its neighbours do not hold the point. The sign of n . d with n = (b
// - a) x (c - a) decides whether a ray leaves on the side from which the surface was seen.
//
// Reflected and refracted rays start at O. Shadow rays start at the light, which is a lattice point. So their
// direction needs no rounding, they end exactly at O, and the box and triangle tests see an origin without
// fraction bits. Symbols: N coord_bits, M dir_bits, B fraction bits of O, 2 <= B <= bary_bits.
#include <cstdint>
#include <optional>

#include "model/core/payloads.hpp"

namespace rayclock {

constexpr int least_origin_bits = 2;   ///< with fewer bits no point lies inside
constexpr int max_origin_bits = 16;

/// Signed widths of the triangle test's values.
struct RayWidths {
    int point, direction, offset;   ///< O or light; d; s = origin - a (in O's units for rays from O)
    int det, edge, num;             ///< edge: u, v, w
};
constexpr RayWidths bounce_widths(int coord_bits, int dir_bits, int frac_bits) {
    return {coord_bits + frac_bits,
            dir_bits,
            coord_bits + frac_bits + 1,
            2 * coord_bits + dir_bits + 2,
            2 * coord_bits + dir_bits + 2 + frac_bits,
            3 * coord_bits + 2 + frac_bits};
}
constexpr RayWidths shadow_widths(int coord_bits, int frac_bits) {
    return {coord_bits,
            coord_bits + frac_bits + 1,
            coord_bits + 1,
            3 * coord_bits + frac_bits + 3,
            3 * coord_bits + frac_bits + 3,
            3 * coord_bits + 2};
}

/// Weights of b and c in units of 2^-B. The weight of a is 2^B minus both. All three are at least 1.
struct Weights {
    std::uint32_t u = 0, v = 0;
};
/// Returns the weights of a hit whose u and v were rounded down to `bary_bits` bits. It rounds them to B bits
/// (halves up) and then moves them off the border. At most 2 units of weight move from one corner to another,
/// so the point moves by at most 2^(1-B) of the longest edge.
Weights inner_weights(std::uint32_t u, std::uint32_t v, int bary_bits, int frac_bits);

/// A point in units of 2^-B lattice steps: N + B bits, signed.
struct SurfacePoint {
    Vec3l at{};
    int frac_bits = 0;
};
/// Returns a + (u (b - a) + v (c - a)) / 2^B, without rounding.
SurfacePoint surface_point(const PrimData& triangle, const Weights& weights, int frac_bits);

/// Return the sign of n . d, the side on which a direction leaves, and of n . (point - a), the side of a
/// lattice point. |n . d| < 2^(2N+M+1).
int side_of_direction(const PrimData& triangle, const Vec3i& d);
int side_of_point(const PrimData& triangle, const Vec3i& point);

/// Returns a direction of any length (at most 61 bits, not 0) cut to M bits. It shifts as little as possible
/// and rounds each component towards the side `facing` (1 or -1) of the normal's component. So if n . way has
/// the sign `facing`, n . d has it too, and the ray leaves on the right side.
Vec3i leaving_direction(const Vec3l& way, const PrimData& triangle, int facing, int dir_bits);

/// The crossing of a ray and a triangle at origin + t d, t = num / det, both positive. For a ray from O, t is
/// in units of 2^-B.
struct OriginHit {
    Int128 num = 0, det = 0;
};
/// Tests a ray from O with tri_test's decisions. u, v, w and num have B bits more; ties follow the same rule.
std::optional<OriginHit> bounce_test(const SurfacePoint& o, const Vec3i& d, const PrimData& triangle);
/// True if num1 / det1 < num2 / det2, exactly. The products have up to 5N + M + 4 + B bits.
bool nearer(const OriginHit& one, const OriginHit& other);

/// Returns the direction of a shadow ray from a light to O: 2^B (O - light), N + B + 1 bits. The ray reaches
/// O at t = 2^-B. Send it only if the light lies strictly on the side of the surface from which it was seen.
Vec3l shadow_direction(const Vec3i& light, const SurfacePoint& o);
/// True if the triangle lies between the light and O: 0 < t < 2^-B, that is 0 < num 2^B < det. A triangle
/// that holds O or the light does not count.
bool shadow_test(const Vec3i& light, const Vec3l& d, int frac_bits, const PrimData& triangle);

/// The lattice points that replace O in the box test of a ray from O: `near` where the ray enters a slab,
/// `far` where it leaves one. On each axis one is O rounded down and the other O rounded up, so near
/// distances are never too large and far ones never too small.
struct BoxOrigin {
    Vec3i near{}, far{};
};
BoxOrigin box_origin(const SurfacePoint& o, const Vec3i& d);

}   // namespace rayclock
