#pragma once
// Ray against triangle in integers of any width. It follows from the geometry alone: signed volumes show on
// which side of each edge the ray passes. It shares no formula with the units that it judges.
//
// There are two number types. Short holds coordinates, differences and products of two of them; Int holds
// volumes. With N-bit coordinates and M-bit directions, differences have N + 1 bits. Cross products of two
// differences are below 2^(2N + 3). Volumes with a direction are below 2^(2N + M + 4), and volumes of three
// differences below 2^(3N + 5). 64 and 128 bits suffice for N = 20, M = 24. A version with 256 bits that
// detects overflow judges them (tests/system).
#include <array>
#include <cstdint>
#include <optional>

#include "model/core/payloads.hpp"

namespace rayclock::oracle {

/// A triangle's corners on the lattice.
struct Corners {
    Vec3i a{}, b{}, c{};
};

/// Returns true if the triangles have a corner in common.
inline bool share_corner(const Corners& s, const Corners& t) {
    for (const Vec3i& p : {s.a, s.b, s.c})
        if (p == t.a || p == t.b || p == t.c) return true;
    return false;
}

template <class Number> using Triple = std::array<Number, 3>;

template <class Number> Triple<Number> triple(const Vec3i& v) {
    return {Number(v[0]), Number(v[1]), Number(v[2])};
}
/// Returns the vector from b to a.
template <class Number> Triple<Number> way(const Triple<Number>& b, const Triple<Number>& a) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Returns the cross product: the area of the parallelogram over two vectors, as a vector.
template <class Short> Triple<Short> area(const Triple<Short>& a, const Triple<Short>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Returns (b - a) x (c - a).
template <class Number> Triple<Number> normal(const Corners& t) {
    const auto a = triple<Number>(t.a);
    return area(way(a, triple<Number>(t.b)), way(a, triple<Number>(t.c)));
}
/// Returns the signed volume of the parallelepiped over a vector and an area.
template <class Int, class Short> Int volume(const Triple<Short>& a, const Triple<Short>& bc) {
    return Int(a[0]) * Int(bc[0]) + Int(a[1]) * Int(bc[1]) + Int(a[2]) * Int(bc[2]);
}

template <class Int> Int volume(const Triple<Int>& a, const Triple<Int>& b, const Triple<Int>& c) {
    return volume<Int>(a, area(b, c));
}

/// Returns the side of the directed edge p -> q on which the line along d through the origin passes. The
/// origin is moved by o' = (e, e^2, e^3), e -> 0+. The result is the sign of volume(d, p - o', q - o');
/// `value` is that volume without the move. Both p and q are relative to the origin. The coefficient of o'[k]
/// is -volume(d, axis k, q) - volume(d, p, axis k). Terms with two moves vanish, since both moves would be in
/// equal rows. The result is 0 only if d is parallel to the edge.
template <class Int, class Short>
int side(const Int& value, const Triple<Short>& d, const Triple<Short>& p, const Triple<Short>& q) {
    if (value != 0) return value > 0 ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
        Triple<Short> axis{Short(0), Short(0), Short(0)};
        axis[k] = 1;
        const Int slope = -volume<Int>(d, area(axis, q)) - volume<Int>(d, area(p, axis));
        if (slope != 0) return slope > 0 ? 1 : -1;
    }
    return 0;
}

/// The crossing of a ray and a triangle, at o + d num / den. The sense is 1 if the ray passes from the side
/// to which the normal (b - a) x (c - a) points to the other side. That is, it enters a body whose normals
/// point outwards. The sense is -1 if it leaves.
template <class Int> struct Passage {
    Int num, den;   ///< den > 0
    int sense;
};

/// Returns the crossing at t > 0, or nothing. A triangle seen edge-on is not crossed.
///
/// With a, b, c relative to the origin, n = b x c + c x a + a x b is the triangle's normal. It satisfies n .
/// a = volume(a, b, c). So n . (t d - a) = 0 gives t = volume(a, b, c) / (volume(d, b, c) + volume(d, c, a) +
/// volume(d, a, b)).
template <class Int, class Short = Int>
std::optional<Passage<Int>> cross(const Vec3i& origin, const Vec3i& direction, const Corners& t) {
    const Triple<Short> o = triple<Short>(origin), d = triple<Short>(direction);
    const Triple<Short> a = way(o, triple<Short>(t.a)), b = way(o, triple<Short>(t.b)),
                        c = way(o, triple<Short>(t.c));
    const Triple<Short> bc = area(b, c), ca = area(c, a);
    const Int along_bc = volume<Int>(d, bc), along_ca = volume<Int>(d, ca);
    if ((along_bc > 0 && along_ca < 0) || (along_bc < 0 && along_ca > 0))
        return std::nullopt;   // most calls end here
    const Int along_ab = volume<Int>(d, area(a, b));
    const int first = side(along_bc, d, b, c);
    if (first == 0 || side(along_ca, d, c, a) != first || side(along_ab, d, a, b) != first)
        return std::nullopt;
    const Int size = along_bc + along_ca + along_ab, height = volume<Int>(a, bc);
    if (size == 0 || height == 0 || (height > 0) != (size > 0)) return std::nullopt;
    if (size < 0) return Passage<Int>{-height, -size, 1};
    return Passage<Int>{height, size, -1};
}

}   // namespace rayclock::oracle
