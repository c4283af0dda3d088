#pragma once
// Converts a hit of a floating-point test to the machine's numbers.
#include <algorithm>
#include <cmath>

#include "model/unit/tri/tri_test.hpp"

namespace rayclock {

/// Fills `out` from a hit of a floating-point test, if it ranks before `best`. num is t 2^(2N+M-2) rounded up
/// and det is 2^(2N+M-2), which keeps far more bits of t than a float has. The exact rules for t, u and v
/// follow. Requires t > 0, and u and v in 0..1. Among equals only the best counts. Beyond 2^(N+2-(M-1)),
/// where TriRsp::t saturates, all t are the same.
inline void float_hit(double t, double u, double v, const PrimData& triangle, const Best& best,
                      const Config& config, TriRsp& out) {
    const int frac = 2 * config.coord_bits + config.dir_bits - 2;
    const double most = std::ldexp(1, 3 * config.coord_bits + 1) - 1;
    // At least one, since t > 0. The cast is exact, or for 60 bits and more rounded by double, which is the
    // same on every machine.
    const auto num = std::int64_t(std::clamp(std::ceil(std::ldexp(t, frac)), 1.0, std::min(most, 0x1p61)));
    if (best.found && (num > best.num || (num == best.num && triangle.prim > best.prim))) return;
    const auto weight = [&](double x) {
        return std::uint32_t(std::ldexp(std::clamp(x, 0.0, 1.0), config.bary_bits));
    };
    out.closer = 1;
    out.num = num;
    out.det = std::int64_t(1) << frac;
    out.prim = triangle.prim;
    out.t = std::uint32_t(std::min(std::ceil(std::ldexp(t, config.dir_bits - 1 + config.t_frac_bits)),
                                   double((1u << config.t_bits()) - 1)));
    out.u = weight(u);
    out.v = weight(v);
}

}   // namespace rayclock
