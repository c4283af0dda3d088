#pragma once
// Where secondary rays begin: at a point of the surface itself, so that no epsilon is needed. docs/origins.md
// has the proofs.
//
// The point O lies strictly inside the triangle that was hit, exactly in its plane, and has B fraction bits.
// From there every decision is exact, as for camera rays: the triangle itself and all that lie in its plane
// have num = 0, and t > 0 leaves them out; its neighbours do not hold the point. Whether a ray leaves on the
// side from which the surface was seen is the sign of n . d, n = (b - a) x (c - a). Reflected and refracted
// rays go out from O. Shadow rays come in from the light, which is a lattice point: their direction then
// needs no rounding, they end exactly at O, and box and triangle tests see an origin without fraction bits.
// Symbols: N coord_bits, M dir_bits, B fraction bits of O, 2 <= B <= bary_bits.
#include <cstdint>
#include <optional>

#include "model/core/payloads.hpp"

namespace rayclock {

constexpr int least_origin_bits = 2;   ///< with fewer no point lies inside
constexpr int most_origin_bits = 16;

/// Signed widths that the triangle test needs.
struct RayWidths {
    int point, direction, offset;   ///< O or light, d, s = origin - a (s in O's units for rays from O)
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

/// Weights of b and c in units of 2^-B; that of a is what is missing to 2^B. All three are at least 1.
struct Weights {
    std::uint32_t u = 0, v = 0;
};
/// From a hit's u and v, rounded down to `bary_bits` bits: rounded to B bits (halves up), then moved off the
/// border. At most 2 units of weight move from one corner to another, so the point moves by at most 2^(1-B)
/// of the longest edge.
Weights inner_weights(std::uint32_t u, std::uint32_t v, int bary_bits, int frac_bits);

/// A point in units of 2^-B lattice steps: N + B bits, signed.
struct SurfacePoint {
    Vec3l at{};
    int frac_bits = 0;
};
/// a + (u (b - a) + v (c - a)) / 2^B, without rounding.
SurfacePoint surface_point(const PrimData& triangle, const Weights& weights, int frac_bits);

/// Sign of n . d, and of n . (point - a): on which side a direction leaves, a lattice point lies. |n . d| <
/// 2^(2N+M+1).
int side_of_direction(const PrimData& triangle, const Vec3i& d);
int side_of_point(const PrimData& triangle, const Vec3i& point);

/// A direction of any length (at most 61 bits, not 0) cut to M bits: shifted as little as possible, each
/// component rounded towards the side `facing` (1 or -1) of the normal's component. So rounding cannot make a
/// ray leave on the wrong side: if n . way has the sign `facing`, n . d has it too.
Vec3i leaving_direction(const Vec3l& way, const PrimData& triangle, int facing, int dir_bits);

/// Where a ray crosses a triangle: at origin + t d, t = num / det, both positive. Of a ray from O, t is in
/// units of 2^-B.
struct OriginHit {
    Wide num = 0, det = 0;
};
/// Ray from O, with tri_test's decisions: u, v, w and num have B bits more, ties go the same way.
std::optional<OriginHit> bounce_test(const SurfacePoint& o, const Vec3i& d, const PrimData& triangle);
/// num1 / det1 < num2 / det2, exactly; the products have up to 5N + M + 4 + B bits.
bool nearer(const OriginHit& one, const OriginHit& other);

/// The direction of a shadow ray from a light to O: 2^B (O - light), N + B + 1 bits. O is reached at t =
/// 2^-B. Such a ray is only sent if the light lies strictly on the side of the surface from which it was
/// seen.
Vec3l shadow_direction(const Vec3i& light, const SurfacePoint& o);
/// The triangle stands between the light and O: 0 < t < 2^-B, that is 0 < num 2^B < det. Nothing that holds O
/// or the light counts.
bool shadow_test(const Vec3i& light, const Vec3l& d, int frac_bits, const PrimData& triangle);

/// Lattice points that stand for O in the box test of a ray from O: `near` wherever a slab is entered, `far`
/// wherever it is left. On each axis one is O rounded down and the other O rounded up, so that near distances
/// are never too large and far ones never too small.
struct BoxOrigin {
    Vec3i near{}, far{};
};
BoxOrigin box_origin(const SurfacePoint& o, const Vec3i& d);

}   // namespace rayclock
