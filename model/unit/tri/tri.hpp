#pragma once
// The unit tri: the exact test, and the quotients of a hit.
#include <algorithm>

#include "model/core/payloads.hpp"

namespace rayclock {

/// Ray-triangle test with exact decisions.
///
/// With e1 = b - a, e2 = c - a, s = o - a (Moller and Trumbore 1997, without division):
///       P1 = d x e1, P2 = d x e2, det = P2 . e1,
///       u = P2 . s, v = -P1 . s, w = det - u - v, num = (e1 x e2) . s,
/// all turned so that det > 0. The ray's line crosses the triangle where u, v, w >= 0, at t = num / det > 0.
///
/// Ties: an edge function that is exactly zero takes the sign that it would have for the origin o + (eps,
/// eps^2, eps^3). All triangles share this infinitesimal step (simulation of simplicity, Edelsbrunner and
/// Muecke 1990). The sign is that of the first non-zero component of its gradient: P2 for u, -P1 for v, P1 -
/// P2 for w. So two triangles that share an edge never both take or both lose a ray. A triangle seen edge-on
/// (det = 0) takes none.
///
/// Closest: num1 det2 < num2 det1, exact. Equal t goes to the lower primitive number. Widths: |u|, |v|, |w|,
/// det < 2^(2N+M+1), |num| < 2^(3N+1). Mirror of rtl/unit/tri/rc_tri.sv, latency Config::tri_latency() + 1,
/// one triangle every Config::tri_interval cycles.
void tri_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
              const Config& config, TriRsp& out);

/// Answers a request of the unit tri with the test that the configuration names.
TriRsp tri(const TriReq& req, const Config& config);

/// floor(num 2^shift / det), and whether there is a remainder, for 0 <= num and 0 < det < 2^63. It saturates
/// at 2^33 - 1 without remainder.
struct Quotient {
    std::uint64_t whole = 0;
    bool rest = false;
};
inline Quotient quotient(std::int64_t num, int shift, std::int64_t det) {
    // Double precision is right to within 2^-17. The remainder, modulo 2^64, then shows whether the quotient
    // is off by one.
    const double near = double(num) * double(std::int64_t(1) << shift) / double(det);
    constexpr std::uint64_t most = (std::uint64_t(1) << 33) - 1;
    if (near >= 0x1p34) return {most, false};
    std::uint64_t whole = std::uint64_t(std::int64_t(near)), size = std::uint64_t(det);
    std::uint64_t rest = (std::uint64_t(num) << shift) - whole * size;
    if (rest >= std::uint64_t(3) << 62) {   // slightly negative
        --whole;
        rest += size;
    } else if (rest >= size) {
        ++whole;
        rest -= size;
    }
    return whole < most ? Quotient{whole, rest != 0} : Quotient{most, false};
}

/// Return t, and u or v, as TriRsp holds them.
inline std::uint32_t distance(std::int64_t num, std::int64_t det, const Config& config) {
    const Quotient q = quotient(num, config.dir_bits - 1 + config.t_frac_bits, det);
    return std::uint32_t(std::min(q.whole + q.rest, (std::uint64_t(1) << config.t_bits()) - 1));
}
inline std::uint32_t barycentric(std::int64_t edge, std::int64_t det, const Config& config) {
    return std::uint32_t(quotient(edge, config.bary_bits, det).whole);
}

}   // namespace rayclock
