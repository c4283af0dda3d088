#pragma once
// Triangles prepared for many rays from one origin.
#include "model/unit/tri/edges.hpp"

namespace rayclock {

/// A triangle seen from one origin, for many directions d. tri_test's det, u and v are linear in d, and num
/// does not depend on d. With e1 = b - a, e2 = c - a, s = o - a:
///       det = d . (e2 x e1), u = d . (e2 x s), v = d . (s x e1), num = (e1 x e2) . s.
struct Facet {
    /// Coefficients, signed and modulo 2^64, because intermediate sums may exceed 64 bits.
    std::array<std::uint64_t, 3> det{}, u{}, v{};
    std::int64_t num = 0;
    std::uint32_t prim = 0;
};

/// Returns the facet of a triangle seen from the lattice point o.
inline Facet make_facet(const PrimData& triangle, const Vec3i& o) {
    using Vec = std::array<std::uint64_t, 3>;
    const auto minus = [](const Vec3i& a, const Vec3i& b) {
        Vec d{};
        for (std::size_t k = 0; k < 3; ++k) d[k] = std::uint64_t(std::int64_t(a[k]) - b[k]);
        return d;
    };
    const auto cross = [](const Vec& a, const Vec& b) {
        return Vec{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const Vec e1 = minus(triangle.b, triangle.a), e2 = minus(triangle.c, triangle.a),
              s = minus(o, triangle.a);
    Facet facet{cross(e2, e1), cross(e2, s), cross(s, e1), 0, triangle.prim};
    facet.num = -std::int64_t(facet.det[0] * s[0] + facet.det[1] * s[1] + facet.det[2] * s[2]);
    return facet;
}

/// Returns the edge functions of a facet and a direction, before signs are turned. If on_edge() holds,
/// tri_test() must decide.
inline Edges<std::int64_t> test_facet(const Facet& f, const Vec3i& direction) {
    const auto dot = [&](const std::array<std::uint64_t, 3>& a) {
        std::uint64_t sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += a[k] * std::uint64_t(std::int64_t(direction[k]));
        return std::int64_t(sum);
    };
    return {dot(f.det), dot(f.u), dot(f.v), f.num};
}

}   // namespace rayclock
