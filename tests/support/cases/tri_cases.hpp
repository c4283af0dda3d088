#pragma once
// Requests for tri, and the judgement of its answers by exact geometry.
#include "model/unit/tri/sheared.hpp"
#include "tests/support/oracle/fractions.hpp"
#include "tests/support/world/traffic.hpp"

namespace rayclock::test {

inline std::optional<oracle::Crossing> crossing(const TriReq& req) {
    return oracle::crossing(oracle::point(req.o), oracle::point(req.d), oracle::point(req.triangle.a),
                            oracle::point(req.triangle.b), oracle::point(req.triangle.c));
}

/// Draws a hit to beat: none, any, exactly as far as the crossing at t (as another fraction), or slightly
/// nearer or farther.
inline Best random_best(Draw& draw, const Config& config, const std::optional<oracle::Rational>& t,
                        std::uint32_t prim) {
    Best best;
    if (draw.coin()) return best;
    best.found = 1;
    best.num = std::int64_t(draw.bits(config.num_bits() - 1) | 1);
    best.det = std::int64_t(draw.bits(config.edge_bits() - 1) | 1);
    const std::uint32_t others[] = {prim, prim - 1, prim + 1, std::uint32_t(draw.natural(max_prim_bits))};
    best.prim = others[draw.below(4)];
    if (!t || draw.below(4) == 0) return best;
    const oracle::Int num = numerator(*t), den = denominator(*t);
    oracle::Int factor = draw.between(1, 5);
    const oracle::Int num_most = (oracle::Int(1) << (config.num_bits() - 1)) - 1,
                      det_most = (oracle::Int(1) << (config.edge_bits() - 1)) - 1;
    if (num * factor > num_most || den * factor > det_most) factor = 1;
    best.num = oracle::Int(num * factor).convert_to<std::int64_t>();
    best.det = oracle::Int(den * factor).convert_to<std::int64_t>();
    if (draw.coin()) return best;
    if (draw.coin() && best.num < num_most)
        ++best.num;
    else if (best.num > 1)
        --best.num;
    return best;
}

/// Returns the ray's crossing of the triangle, in the units in which the test compares.
inline std::optional<oracle::Rational> crossing_to_beat(const TriReq& req, const Config& config) {
    if (config.is_sheared()) {
        const TriRsp rsp = tri(req, config);
        return rsp.closer ? std::optional(oracle::Rational(rsp.num, rsp.det)) : std::nullopt;
    }
    const auto at = crossing(req);
    return at ? std::optional(at->t) : std::nullopt;
}

/// Most rays aim at a corner, the middle of an edge or the inside. Some run backwards.
inline TriReq random_tri_req(Draw& draw, const Config& config) {
    const int n = config.coord_bits;
    TriReq req;
    req.ray = std::uint32_t(draw.natural(config.ray_bits()));
    req.triangle.a = draw.vector(n);
    const int reach = 1 << draw.below(n - 1);
    req.triangle.b = draw.coin() ? draw.vector(n) : draw.near(req.triangle.a, reach, n);
    req.triangle.c = draw.coin() ? draw.vector(n) : draw.near(req.triangle.b, reach, n);
    req.triangle.prim = std::uint32_t(draw.natural(max_prim_bits));
    req.o = draw.coin() ? draw.vector(n) : draw.near(req.triangle.a, reach, n);
    req.d = draw.vector(config.dir_bits);
    if (draw.percent(75)) {
        const int weights[][3] = {{4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {2, 2, 0}, {2, 0, 2},
                                  {0, 2, 2}, {1, 1, 2}, {2, 1, 1}, {1, 2, 1}};
        const auto& w = weights[draw.below(9)];
        const int factor = draw.below(4) == 0 ? draw.between(-2, 4) : 1;
        const std::int64_t most = (std::int64_t(1) << (config.dir_bits - 1)) - 1;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t way = std::int64_t(w[0]) * req.triangle.a[k] +
                                     std::int64_t(w[1]) * req.triangle.b[k] +
                                     std::int64_t(w[2]) * req.triangle.c[k] - 4 * std::int64_t(req.o[k]);
            req.d[k] = std::int32_t(std::clamp((way >> 2) * factor, -most - 1, most));
        }
    }
    if (config.is_sheared()) req.shear = shear_of(req.d, config);
    req.best = random_best(draw, config, crossing_to_beat(req, config), req.triangle.prim);
    return req;
}

/// Requires that the answer is exactly the geometry's.
inline void judge(const TriReq& req, const TriRsp& rsp, const Config& config) {
    const auto at = crossing(req);
    bool closer = at.has_value();
    if (at && req.best.found)
        closer = oracle::goes_before(at->t, req.triangle.prim, oracle::Rational(req.best.num, req.best.det),
                                     req.best.prim);
    REQUIRE(rsp.ray == req.ray);
    REQUIRE(rsp.closer == closer);
    if (!closer) {
        REQUIRE((rsp.num == 0 && rsp.det == 0 && rsp.prim == 0 && rsp.t == 0 && rsp.u == 0 && rsp.v == 0));
        return;
    }
    const oracle::Rational weight = oracle::power_of_two(config.bary_bits);
    const oracle::Int beyond = (oracle::Int(1) << config.t_bits()) - 1;
    const oracle::Int t =
        oracle::ceil(at->t * oracle::power_of_two(config.dir_bits - 1 + config.t_frac_bits));
    REQUIRE(rsp.prim == req.triangle.prim);
    REQUIRE(rsp.det == at->volume);
    REQUIRE(oracle::Rational(rsp.num, rsp.det) == at->t);
    REQUIRE(rsp.t == std::min(t, beyond));
    REQUIRE(rsp.u == oracle::floor(at->u * weight));
    REQUIRE(rsp.v == oracle::floor(at->v * weight));
}

}   // namespace rayclock::test
