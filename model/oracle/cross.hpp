#pragma once
// Ray against triangle in whole numbers of any width, written from the geometry: on which side of each edge the ray passes, by
// signed volumes. Shares no formula with the units it judges.
//
// Int must hold every volume: with coordinates of N bits and directions of M bits, differences have N + 1 bits, so that one of
// the six products of a volume is below 2^(2(N+1) + M) and their sum below 2^(2N + M + 5); that of the plane's equation, with
// three differences, below 2^(3N + 6). 128 bits do for N = 20, M = 24, and 256 for products of two volumes of any format.
#include <array>
#include <cstdint>
#include <optional>

#include "model/core/payloads.hpp"

namespace rayclock::oracle {

/// A triangle's corners on the lattice.
struct Corners {
    Vec3i a{}, b{}, c{};
};

template <class Int> using Triple = std::array<Int, 3>;

template <class Int> Triple<Int> triple(const Vec3i& v) { return {Int(v[0]), Int(v[1]), Int(v[2])}; }
/// From b to a.
template <class Int> Triple<Int> way(const Triple<Int>& b, const Triple<Int>& a) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Signed volume of the parallelepiped over three vectors, by Sarrus' rule.
template <class Int> Int volume(const Triple<Int>& a, const Triple<Int>& b, const Triple<Int>& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// On which side of the directed edge p -> q the line along d through the origin passes, if the origin is moved by
/// (e, e^2, e^3), e -> 0+: the sign of volume(d, p - o', q - o'). p and q are relative to the origin. Its coefficient of
/// o'[k] is -volume(d, axis k, q) - volume(d, p, axis k), and terms of two moves vanish, since both would stand in equal
/// rows. 0 only if d is parallel to the edge.
template <class Int> int side(const Triple<Int>& d, const Triple<Int>& p, const Triple<Int>& q) {
    const Int value = volume(d, p, q);
    if (value != 0) return value > 0 ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
        Triple<Int> axis{Int(0), Int(0), Int(0)};
        axis[k] = 1;
        const Int slope = -volume(d, axis, q) - volume(d, p, axis);
        if (slope != 0) return slope > 0 ? 1 : -1;
    }
    return 0;
}

/// Where a ray crosses a triangle: at o + d num / den. The sense is 1 if the ray passes from the side to which the normal
/// (b - a) x (c - a) points to the other, that is, enters a body whose normals point outwards; -1 if it leaves.
template <class Int> struct Passage {
    Int num, den;   ///< den > 0
    int sense;
};

/// The crossing at t > 0, or nothing. A triangle seen edge-on is not crossed.
template <class Int> std::optional<Passage<Int>> cross(const Vec3i& origin, const Vec3i& direction, const Corners& t) {
    const Triple<Int> o = triple<Int>(origin), d = triple<Int>(direction);
    const Triple<Int> a = way(o, triple<Int>(t.a)), b = way(o, triple<Int>(t.b)), c = way(o, triple<Int>(t.c));
    const int ab = side(d, a, b);
    if (ab == 0 || side(d, b, c) != ab || side(d, c, a) != ab) return std::nullopt;
    // n . (t d - a) = 0 with n = ab x ac: t = volume(a, ab, ac) / volume(d, ab, ac).
    const Triple<Int> along = way(a, b), across = way(a, c);
    Int num = volume(a, along, across), den = volume(d, along, across);
    const int sense = den < 0 ? 1 : -1;
    if (den < 0) {
        num = -num;
        den = -den;
    }
    if (den == 0 || num <= 0) return std::nullopt;
    return Passage<Int>{num, den, sense};
}

} // namespace rayclock::oracle
