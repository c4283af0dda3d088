#pragma once
// The test of a ray of any kind and a primitive of any kind, and its square root.
#include <cstdint>

#include "model/unit/tri/edges.hpp"

namespace rayclock {

/// Tests a ray of any kind and a primitive of any kind, in a chip that shades. Decisions about triangles and
/// planes are exact, and so is the decision whether a ray meets a sphere. The distance to a sphere holds a
/// square root, which rounds (see Root).
///
/// ## Units
///
/// The origin of a camera or shadow ray is a lattice point (ray.o has B zeros). The origin of a bounce, or of
/// a ray away to a light, has B fraction bits. For these s = o - 2^B a, so 2^B is the one of u, v, w and num.
/// det is taken times 2^B, so that t = num / det for every ray. The rules for a bounce also hold for a ray
/// away, except that any hit blocks it.
///
/// ## Triangles and planes
///
///     primitive   formulas and ties
///     triangle    those of tri_test()
///     plane       the same without edges; u and v are rounded down, signed, and saturate
///
///     ray         blocked (closer = 1, everything else 0) if
///     shadow      0 < num 2^B < det; a primitive that holds the light or the point does not block it
///     away        a bounce would hit the primitive
///
/// ## Spheres: camera rays, bounces and rays away
///
/// The centre is c and the squared radius R2. With s = 2^B (o - c), b = d.s, A = d.d, C = s.s - 4^B R2 and
/// D = b b - A C, the ray meets the sphere at t = (-b -+ sqrt(D)) / (2^B A):
///
///     origin               met if               root
///     outside, C > 0       b < 0 and D >= 0     near; a touch counts
///     inside, C < 0        d is not 0           far
///     on it, C = 0         b < 0                far; the other root t = 0 is not a hit
///     outside its own      never
///     inside its own       always               far, also where O was rounded to C > 0
///
/// "Its own" is the sphere that a bounce leaves. The inside of an opaque sphere cannot be seen
/// (is_seen_inside()): its far root is never a hit.
///
/// ## Spheres: shadow rays
///
/// A shadow ray goes from the light L to the point O, with s = L - c in lattice units and d = 2^B (O - L). O
/// is inside if |O - c|^2 < R2, that is E = A + 2^(B+1) b + 4^B C < 0:
///
///     light                            blocked if
///     outside, C > 0                   b < 0, D >= 0 and (E < 0 or -b 2^B < A): a root lies before O
///     inside, C < 0                    E > 0
///     on it, C = 0                     b < 0 and E > 0
///     the point's own, from outside    never
///     the point's own, from inside     C > 0: the light is outside
///
/// The point's view of the light counts, although the ray runs the other way. So an opaque sphere blocks in
/// these cases only if O is outside, E > 0, and never if it is the point's own. A ray away from the point
/// starts at the wrong end for this rule: the host handles a light inside an opaque sphere
/// (ShadeFrame::clear).
///
/// ## Root
///
/// x = D / 4^k is cut to 2 root_bits bits, with the smallest possible k, and p = floor(sqrt(x)). r stands for
/// sqrt(D):
///
///     root    r                                                  bound
///     near    p 2^k                                              not above sqrt(D)
///     far     p 2^k if this is sqrt(D), otherwise (p + 1) 2^k    not below sqrt(D)
///
/// Both are off by less than 2^k. As D >= 4^(k - 1 + root_bits) where k > 0,
/// 2^k <= max(1, sqrt(D) 2^(1 - root_bits)).
///
/// t = ceil(2^(M-1+F-B) (-b -+ r) / A), saturated at all ones, is at least 1 and never below the true t (in
/// its units). It is above the true t by less than
///         1 + 2^(M-1+F-B) 2^k / A <= 1 + max(2^(M-1+F-B) / A, 2^(1 - root_bits) T),
/// where T is the radius as the ray measures it: sqrt(R2) 2^(M-1+F) / |d|, since D <= A R2 4^B
/// (Cauchy-Schwarz). For a ray that fills its bits, |d| >= 2^(M-2), this is 1 + max(2^(F-B-M+3),
/// 2^(N+F+2-root_bits)): at most 1.07 units for `default`, 9 for the widest t.
///
/// The hit to compare is num = t, det = 2^(M-1+F), so it ranks among other hits exactly at its t. A saturated
/// one ranks at all ones.
void any_primitive_test(const Ray& ray, const PrimData& prim, const Best& best, const Config& config,
                        TriRsp& out);

/// True if the sphere's inside can be seen, because its material transmits. Memory holds this in the lowest
/// bit of b[2].
inline bool is_seen_inside(const PrimData& sphere) { return (sphere.b[2] & 1) != 0; }

/// Bits of the sphere test's values, signed except for A, the root and the quotient's numerator. With N
/// lattice, M direction and B fraction bits, components have |s| < 2^(N+B), |d| <= 2^(M-1) for a bounce, and
/// |s| < 2^N, |d| < 2^(N+B) for a shadow ray. Camera rays are bounces whose fraction is 0.
struct SphereWidths {
    int offset;      ///< s
    int direction;   ///< d
    int square;      ///< A < 3 4^(M-1), 3 4^(N+B)
    int along;       ///< |b| < 3 2^(M-1+N+B), 3 2^(2N+B)
    int power;       ///< |C| < 3 4^(N+B); also E, which is |O - c|^2 - R2 in units of 4^-B
    /// D = A R2 4^B - |d x s|^2, |D| < 2 4^(M+N+B), 8 4^(2N+B). The corners give these bounds, as |d x s|^2
    /// is convex in each component.
    int disc;
    int num;   ///< -b -+ r <= sqrt(A) (sqrt(s.s) + sqrt(R2) 2^B) + 2^k < 2^(M+N+B+2)
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

/// A square root rounded down, and the right shift of its argument's root: sqrt(D) / 2^shift -
/// 1 < whole <= sqrt(D) / 2^shift.
struct Root {
    std::uint32_t whole = 0;   ///< root_bits bits
    int shift = 0;
    bool rest = false;   ///< true if whole 2^shift is not sqrt(D)
};
Root root(WideNatural square);

}   // namespace rayclock
