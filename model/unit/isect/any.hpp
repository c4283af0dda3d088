#pragma once
#include <cstdint>

#include "model/unit/isect/edges.hpp"

namespace rayclock {

/// The test of a chip that shades: a ray of any kind against a primitive of any kind. Decisions about
/// triangles and planes are exact, of spheres whether they are met at all; where a sphere is met holds a
/// square root, which rounds (below).
///
/// Units. A camera or shadow ray's origin is a lattice point (ray.o has B zeros), that of a bounce or of a
/// ray away to a light has B fraction bits: what is said of a bounce here holds for that as well, but that
/// any hit blocks it. Of a bounce s = o - 2^B a, and with it u, v, w and num, have 2^B for one; its det is
/// taken times 2^B, so that t = num / det for every ray.
///
/// Triangle: tri_test()'s formulas and ties. Plane: the same without edges; u and v are rounded down, signed,
/// and saturate. A shadow ray is blocked (closer = 1, everything else 0) if 0 < num 2^B < det: what holds the
/// light or the point counts not. One away is blocked by what a bounce would hit.
///
/// Sphere, centre c, square of the radius R2: with s = 2^B (o - c), b = d.s, A = d.d, C = s.s - 4^B R2, D = b
/// b - A C, the ray meets it at t = (-b -+ sqrt(D)) / (2^B A).
///   From outside, C > 0: met if b < 0 and D >= 0, at the near root. A touch counts.
///   From inside, C < 0: at the far root, if d is not 0. From on it, C = 0: at the far root if b < 0, else
///   never: t = 0 is no hit. A bounce's own sphere: not met if the ray is outside; if it is inside, the far
///   root, also where O was rounded to C > 0.
/// An opaque sphere has no inside to be seen (is_seen_inside()): its far root is never a hit.
/// A shadow ray, s = L - c, lattice units, d = 2^B (O - L); O is inside if |O - c|^2 < R2, by E = A + 2^(B+1)
/// b + 4^B C < 0:
///   From outside: blocked if b < 0, D >= 0 and (E < 0 or -b 2^B < A): a root lies before O.
///   From inside: blocked if E > 0. From on it: blocked if b < 0 and E > 0.
///   The sphere of the point itself: not if it was seen from outside; if from inside, blocked if C > 0, the
///   light being outside.
/// What counts is how the point sees the light, although the ray runs the other way. So an opaque sphere
/// blocks in these cases only if O is outside, E > 0, and never if it is the point's own. A ray away from a
/// light starts at the wrong end for that rule: the host answers for a light inside an opaque sphere
/// (ShadeFrame::clear).
///
/// The root. x = D / 4^k cut to 2 root_bits bits, k as small as that allows; p = floor(sqrt(x)). The near
/// root takes r = p 2^k, not above sqrt(D); the far one r = p 2^k, or (p + 1) 2^k if p 2^k is not sqrt(D),
/// not below. Both are off by less than 2^k. As D >= 4^(k - 1 + root_bits) where k > 0, 2^k <= max(1, sqrt(D)
/// 2^(1 - root_bits)). t = ceil(2^(M-1+F-B) (-b -+ r) / A), saturated at all ones, is never below the true t
/// (in its units), at least 1, and above it by less than
///     1 + 2^(M-1+F-B) 2^k / A <= 1 + max(2^(M-1+F-B) / A, 2^(1 - root_bits) T),
/// T the radius as the ray measures it: sqrt(R2) 2^(M-1+F) / |d|, since D <= A R2 4^B (Cauchy and Schwarz). A
/// ray that fills its bits, |d| >= 2^(M-2), has 1 + max(2^(F-B-M+3), 2^(N+F+2-root_bits)): at most 1.07 units
/// for `default`, 9 for the widest t. The hit to compare is num = t, det = 2^(M-1+F): among other hits it is
/// exactly where it says it is. One that saturates ranks at all ones.
void any_test(const Ray& ray, const PrimData& prim, const Best& best, const Config& config, TriRsp& out);

/// A sphere is seen from its inside if its material transmits. Memory says so in the lowest bit of b[2].
inline bool is_seen_inside(const PrimData& sphere) { return (sphere.b[2] & 1) != 0; }

/// Bits of the sphere test's values, signed except for A, the root and the quotient's numerator. With N
/// lattice, M direction, B fraction bits, components |s| < 2^(N+B), |d| <= 2^(M-1) of a bounce, |s| < 2^N,
/// |d| < 2^(N+B) of a shadow ray; camera rays are bounces whose fraction is 0.
struct SphereWidths {
    int offset;      ///< s
    int direction;   ///< d
    int square;      ///< A < 3 4^(M-1), 3 4^(N+B)
    int along;       ///< |b| < 3 2^(M-1+N+B), 3 2^(2N+B)
    int power;       ///< |C| < 3 4^(N+B): also E, which is |O - c|^2 - R2 in units of 4^-B
    int disc;   ///< D = A R2 4^B - |d x s|^2, |D| < 2 4^(M+N+B), 8 4^(2N+B): that of the corners, as |d x
                ///< s|^2 is convex in each component
    int num;    ///< -b -+ r <= sqrt(A) (sqrt(s.s) + sqrt(R2) 2^B) + 2^k < 2^(M+N+B+2)
};
constexpr SphereWidths sphere_widths(int coord_bits, int dir_bits, int frac_bits) {
    const auto most = [](int one, int other) { return one > other ? one : other; };
    const int point = coord_bits + frac_bits;
    return {point + 1,
            most(point + 1, dir_bits),
            most(2 * dir_bits, 2 * point + 2),
            most(dir_bits + point + 2, coord_bits + point + 3),
            2 * point + 3,
            most(2 * (dir_bits + point) + 2, 2 * (coord_bits + point) + 4),
            dir_bits + point + 2};
}

/// A square root rounded down, and how far its argument was moved right for that: sqrt(D) / 2^shift - 1 <
/// whole <= sqrt(D) / 2^shift.
struct Root {
    std::uint32_t whole = 0;   ///< root_bits bits
    int shift = 0;
    bool rest = false;   ///< whole 2^shift is not sqrt(D)
};
Root root(WideNatural square);

}   // namespace rayclock
