#pragma once
// The exact triangle test itself, in numbers of 64 or 128 bits: the only place in the model where it is
// written. What is done with its answer is the business of tri_test(), any_test(), the recorder and the tests
// of origins.
#include <cassert>

#include "model/core/payloads.hpp"
#include "model/unit/isect/vectors.hpp"

namespace rayclock {

/// Edge functions of a ray and a triangle, as tri_test() names them. If the ray's origin has fraction bits,
/// all four are in units of the last.
template <class Number> struct Edges {
    Number det = 0, u = 0, v = 0, num = 0;

    Number w() const { return det - u - v; }
    /// An edge function is zero: ties decide.
    bool on_edge() const { return u == 0 || v == 0 || w() == 0; }
    /// If not: the ray's line crosses the triangle. (For det = 0 the three have not all one sign.)
    bool same_signs() const { return ((u ^ det) | (v ^ det) | (w() ^ det)) >= 0; }
    /// And not behind the origin.
    bool ahead() const { return ((u ^ det) | (v ^ det) | (w() ^ det) | (num ^ det)) >= 0; }
    /// Turns all signs if det < 0. Returns whether it was.
    bool turn() {
        const bool flip = det < 0;
        if (flip) det = -det, u = -u, v = -v, num = -num;
        return flip;
    }
};

template <class Number> Number dot(const Vec3l& a, const Vec3l& b) {
    return Number(a[0]) * b[0] + Number(a[1]) * b[1] + Number(a[2]) * b[2];
}

/// True if the edge function is positive, a zero being decided by the first non-zero component of its
/// gradient; `flip` turns all signs.
template <class Number> bool inside(Number edge, const Vec3l& gradient, bool flip) {
    const Number decides = edge != 0          ? edge
                           : gradient[0] != 0 ? gradient[0]
                           : gradient[1] != 0 ? gradient[1]
                                              : gradient[2];
    return flip ? decides < 0 : decides > 0;
}

/// The ray's line crosses the triangle, for det other than 0. The gradients are those of tri_test().
template <class Number> bool crosses(const Edges<Number>& edges, const Vec3l& p1, const Vec3l& p2) {
    // Nearly always no edge function is zero; then their signs alone decide, without a branch for each.
    if (!edges.on_edge()) return edges.same_signs();
    const bool flip = edges.det < 0;
    return inside(edges.u, p2, flip) && inside(edges.v, {-p1[0], -p1[1], -p1[2]}, flip) &&
           inside(edges.w(), {p1[0] - p2[0], p1[1] - p2[1], p1[2] - p2[2]}, flip);
}

/// A ray's line and a triangle, or the triangle's plane if edges do not count.
///
/// s is origin - a with `frac` bits of fraction. Fills `edges`, turned so that det > 0, and says in `flip`
/// whether they were turned. False if the line does not cross the triangle, or not ahead of the origin.
template <class Number> bool meet(const Vec3l& s, const Vec3l& d, const PrimData& triangle, int frac,
                                  bool edges_count, Edges<Number>& edges, bool& flip) {
    const Vec3l e1 = minus(triangle.b, triangle.a), e2 = minus(triangle.c, triangle.a);
    const Vec3l p1 = cross(d, e1), p2 = cross(d, e2);
    const Number det = dot<Number>(p2, e1);
    if (det == 0) return false;
    edges.det = det * (Number(1) << frac);
    edges.u = dot<Number>(p2, s);
    edges.v = -dot<Number>(p1, s);
    if (edges_count && !crosses(edges, p1, p2)) return false;
    edges.num = dot<Number>(cross(e1, e2), s);
    flip = edges.turn();
    return edges.num > 0;
}

__extension__ using WideNatural = unsigned __int128;

/// one * other for factors below 2^96, in two parts.
struct Product {
    WideNatural high;
    std::uint64_t low;
    Product(Wide one, Wide other) {
        assert(one >= 0 && other >= 0 && one >> 96 == 0 && other >> 96 == 0 &&
               "parts of a hit are positive and below 2^96");
        const auto low_of = [](Wide x) { return std::uint64_t(x); };
        const auto high_of = [](Wide x) { return std::uint64_t(x >> 64); };
        const WideNatural bottom = WideNatural(low_of(one)) * low_of(other);
        low = std::uint64_t(bottom);
        high = (bottom >> 64) + WideNatural(low_of(one)) * high_of(other) +
               WideNatural(high_of(one)) * low_of(other) + (WideNatural(high_of(one)) * high_of(other) << 64);
    }
    bool operator<(const Product& p) const { return high != p.high ? high < p.high : low < p.low; }
};

/// num / det goes before the hit to beat: nearer, or as near and of no higher number.
template <class Best>
bool goes_before(std::int64_t num, std::int64_t det, std::uint32_t prim, const Best& best) {
    if (!best.found) return true;
    const Wide mine = Wide(num) * best.det, theirs = Wide(best.num) * det;
    return mine < theirs || (mine == theirs && prim <= best.prim);
}
template <class Best> bool goes_before(Wide num, Wide det, std::uint32_t prim, const Best& best) {
    if (!best.found) return true;
    const Product mine{num, best.det}, theirs{best.num, det};
    return mine < theirs || (!(theirs < mine) && prim <= best.prim);
}

/// What a hit's answer is, whatever the widths: all but t, u and v.
template <class Number>
void put_hit(const Edges<Number>& edges, bool flip, std::uint32_t prim, const Config& config, TriRsp& out) {
    out.closer = 1;
    out.back = flip && config.shading;
    out.num = edges.num;
    out.det = edges.det;
    out.prim = prim;
}

}   // namespace rayclock
