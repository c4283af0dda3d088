#pragma once
// The exact triangle test in numbers of 64 or 128 bits. No other place in the model has its formulas.
// tri_test(), any_primitive_test(), the recorder and the tests of origins use its answer.
#include <cassert>

#include "model/core/payloads.hpp"
#include "model/unit/tri/vectors.hpp"

namespace rayclock {

/// Edge functions of a ray and a triangle, named as in tri_test(). If the ray's origin has fraction bits, all
/// four are in units of the last one.
template <class Number> struct Edges {
    Number det = 0, u = 0, v = 0, num = 0;

    Number w() const { return det - u - v; }
    /// True if an edge function is zero, so that ties decide.
    bool on_edge() const { return u == 0 || v == 0 || w() == 0; }
    /// True if the ray's line crosses the triangle, when on_edge() is false. (For det = 0 the three cannot
    /// all have the same sign.)
    bool same_signs() const { return ((u ^ det) | (v ^ det) | (w() ^ det)) >= 0; }
    /// True if same_signs() and the crossing is not behind the origin.
    bool ahead() const { return ((u ^ det) | (v ^ det) | (w() ^ det) | (num ^ det)) >= 0; }
    /// Turns all signs if det < 0. Returns true if it did.
    bool turn() {
        const bool flip = det < 0;
        if (flip) det = -det, u = -u, v = -v, num = -num;
        return flip;
    }
};

template <class Number> Number dot(const Vec3l& a, const Vec3l& b) {
    return Number(a[0]) * b[0] + Number(a[1]) * b[1] + Number(a[2]) * b[2];
}

/// True if the edge function is positive. If it is zero, the first non-zero component of its gradient
/// decides. `flip` turns all signs.
template <class Number> bool inside(Number edge, const Vec3l& gradient, bool flip) {
    const Number decides = edge != 0          ? edge
                           : gradient[0] != 0 ? gradient[0]
                           : gradient[1] != 0 ? gradient[1]
                                              : gradient[2];
    return flip ? decides < 0 : decides > 0;
}

/// True if the ray's line crosses the triangle, for det != 0. The gradients are those of tri_test().
template <class Number> bool crosses(const Edges<Number>& edges, const Vec3l& p1, const Vec3l& p2) {
    // Nearly always no edge function is zero. Then the signs alone decide, with one branch.
    if (!edges.on_edge()) return edges.same_signs();
    const bool flip = edges.det < 0;
    return inside(edges.u, p2, flip) && inside(edges.v, {-p1[0], -p1[1], -p1[2]}, flip) &&
           inside(edges.w(), {p1[0] - p2[0], p1[1] - p2[1], p1[2] - p2[2]}, flip);
}

/// Intersects a ray's line with a triangle, or with the triangle's plane if `edges_count` is false.
///
/// s is origin - a with `frac` fraction bits. The function fills `edges`, turned so that det > 0, and sets
/// `flip` if it turned them. It returns false if the line does not cross the triangle, or not ahead of the
/// origin.
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

/// The product one * other of factors below 2^96, in two parts.
struct Product {
    WideNatural high;
    std::uint64_t low;
    Product(Int128 one, Int128 other) {
        assert(one >= 0 && other >= 0 && one >> 96 == 0 && other >> 96 == 0 &&
               "parts of a hit are positive and below 2^96");
        const auto low_of = [](Int128 x) { return std::uint64_t(x); };
        const auto high_of = [](Int128 x) { return std::uint64_t(x >> 64); };
        const WideNatural bottom = WideNatural(low_of(one)) * low_of(other);
        low = std::uint64_t(bottom);
        high = (bottom >> 64) + WideNatural(low_of(one)) * high_of(other) +
               WideNatural(high_of(one)) * low_of(other) + (WideNatural(high_of(one)) * high_of(other) << 64);
    }
    bool operator<(const Product& p) const { return high != p.high ? high < p.high : low < p.low; }
};

/// True if num / det ranks before the hit to beat: nearer, or equally near and with no higher number.
template <class Best>
bool goes_before(std::int64_t num, std::int64_t det, std::uint32_t prim, const Best& best) {
    if (!best.found) return true;
    const Int128 mine = Int128(num) * best.det, theirs = Int128(best.num) * det;
    return mine < theirs || (mine == theirs && prim <= best.prim);
}
template <class Best> bool goes_before(Int128 num, Int128 det, std::uint32_t prim, const Best& best) {
    if (!best.found) return true;
    const Product mine{num, best.det}, theirs{best.num, det};
    return mine < theirs || (!(theirs < mine) && prim <= best.prim);
}

/// Fills the parts of a hit's answer that do not depend on widths: all but t, u and v.
template <class Number>
void put_hit(const Edges<Number>& edges, bool flip, std::uint32_t prim, const Config& config, TriRsp& out) {
    out.closer = 1;
    out.back = flip && config.shading;
    out.num = edges.num;
    out.det = edges.det;
    out.prim = prim;
}

}   // namespace rayclock
