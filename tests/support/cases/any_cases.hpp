#pragma once
// Requests for the tri of a shading chip, with every kind of ray and primitive, and the judgement of its
// answers by exact geometry.
#include "model/unit/tri/any_primitive.hpp"
#include "model/unit/tri/tri.hpp"
#include "tests/support/oracle/ball.hpp"
#include "tests/support/world/traffic.hpp"

namespace rayclock::test {

/// Returns a format by name, with the primitives in `kinds`. The names cover both shipped formats, a narrow
/// lattice, the widest, and one with finer distances than any other.
inline Config any_format(const std::string& name, const std::string& kinds = "sphere plane") {
    Config c = format(name == "fine" ? "wide" : name);
    c.shading = 1;
    c.spheres = kinds.find("sphere") != std::string::npos;
    c.planes = kinds.find("plane") != std::string::npos;
    c.textures = kinds.find("cutout") != std::string::npos;
    if (name == "narrow") c.dir_bits = 15, c.origin_bits = 2, c.bary_bits = 5, c.t_frac_bits = 0;
    if (name == "wide") c.origin_bits = 10;
    if (name == "fine") c.origin_bits = 10, c.t_frac_bits = 6, c.bary_bits = 19;
    if (c.spheres)
        // The credit counter accepts a request in every cycle only if the queue is as long as the pipeline.
        c.tri_queue = 64;
    c.horizon = c.planes && c.origin_bits >= far_drop;
    c.name = name + " " + kinds;
    return c;
}

inline Int128 wide_bits(Draw& draw, int bits) {
    return bits <= 64 ? Int128(draw.bits(bits)) : Int128(draw.bits(bits - 64)) << 64 | draw.bits(64);
}
inline oracle::Int big(Int128 x) {
    oracle::Int r = std::int64_t(x >> 64);
    r <<= 64;
    return r + std::uint64_t(x);
}
inline Int128 narrow(const oracle::Int& x) {
    return Int128((x >> 64).convert_to<std::int64_t>()) << 64 |
           oracle::Int(x & ~std::uint64_t(0)).convert_to<std::uint64_t>();
}

// ---- A request in the scene's units: lattice steps, t = num / det.
inline bool is_shadow(const TriReq& r) { return r.kind == RayKind::shadow; }
inline bool leaves(const TriReq& r) { return r.kind == RayKind::bounce || r.kind == RayKind::away; }
/// Returns true for a ray from beyond the lattice. Its origin is in units of 2^far_drop, and it tests only
/// planes.
inline bool is_far(const TriReq& r) { return r.kind == RayKind::bounce && r.is_partial != 0; }
inline bool is_sphere(const TriReq& r, const Config& c) {
    return c.spheres && r.triangle.kind == PrimKind::sphere;
}
inline bool is_opaque(const TriReq& sphere) { return sphere.triangle.b[2] == 0; }
inline bool is_plane(const TriReq& r, const Config& c) {
    return c.planes && r.triangle.kind == PrimKind::plane;
}
inline bool is_cutout(const TriReq& r) { return r.triangle.kind == PrimKind::cutout; }
inline oracle::Place3 place(const Vec3i& p) {
    return {oracle::Rational(p[0]), oracle::Rational(p[1]), oracle::Rational(p[2])};
}
inline oracle::Place3 origin_of(const TriReq& r, const Config& c) {
    oracle::Place3 o = place(r.o);
    for (auto& x : o) x *= oracle::power_of_two((is_far(r) ? far_drop : 0) - c.origin_bits);
    return o;
}
inline oracle::Ball ball_of(const TriReq& r, const Config& c) {
    return {origin_of(r, c), place(r.d), place(r.triangle.a),
            oracle::Rational(radius_squared(r.triangle, c.coord_bits))};
}
inline std::optional<oracle::Crossing> flat_crossing(const TriReq& r, const Config& c) {
    const PrimData& p = r.triangle;
    if (is_plane(r, c))
        return oracle::plane_crossing(origin_of(r, c), place(r.d), place(p.a), place(p.b), place(p.c));
    if (is_far(r)) return std::nullopt;
    // The origin moves by (e, e^2, e^3), so it may as well move in steps of 2^-B: everything is in that unit.
    const auto scaled = [&](const Vec3i& v) {
        return oracle::Point{oracle::Int(v[0]) << c.origin_bits, oracle::Int(v[1]) << c.origin_bits,
                             oracle::Int(v[2]) << c.origin_bits};
    };
    auto at = oracle::crossing(oracle::point(r.o), oracle::point(r.d), scaled(p.a), scaled(p.b), scaled(p.c));
    if (!at) return at;
    at->t *= oracle::power_of_two(-c.origin_bits);
    at->volume *= oracle::power_of_two(-2 * c.origin_bits);
    return at;
}
inline int side_of_ray(const TriReq& r) {
    const auto edge = [&](const Vec3i& to, std::size_t k) { return oracle::Int(to[k]) - r.triangle.a[k]; };
    oracle::Int sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        sum +=
            (edge(r.triangle.b, i) * edge(r.triangle.c, j) - edge(r.triangle.b, j) * edge(r.triangle.c, i)) *
            r.d[k];
    }
    return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}

// ---- Judgement.

/// Returns the units of t in a distance of 1.
inline oracle::Rational unit_of(const Config& c) {
    return oracle::power_of_two(c.dir_bits - 1 + c.t_frac_bits);
}
inline oracle::Int most_t(const Config& c) { return (oracle::Int(1) << c.t_bits()) - 1; }

/// Returns the largest permitted excess of t for a sphere, as stated in model/unit/tri/any_primitive.hpp.
inline oracle::Rational sphere_excess(const oracle::Ball& ball, const Config& c) {
    const oracle::Rational unit = unit_of(c), a = ball.speed_squared();
    const oracle::Rational radius = sqrt(oracle::ceil(ball.radius_squared * unit * unit / a)) + 1;
    return 1 + std::max(oracle::Rational(unit * oracle::power_of_two(-c.origin_bits) / a),
                        oracle::Rational(radius * oracle::power_of_two(1 - root_bits)));
}
inline oracle::SphereRoot sphere_truth(const TriReq& r, const Config& c) {
    const oracle::Ball ball = ball_of(r, c);
    if (is_far(r)) return oracle::SphereRoot::none;
    if (is_opaque(r) && ((leaves(r) && r.self == r.triangle.prim) || ball.outside(0) <= 0))
        return oracle::SphereRoot::none;
    if (leaves(r) && r.self == r.triangle.prim)
        return r.is_inside ? oracle::meets_from_its_surface(ball) : oracle::SphereRoot::none;
    return oracle::meets(ball);
}
/// Returns true if the way back from the line's end, outside the sphere, to its beginning meets the sphere.
inline bool is_in_sight(const oracle::Ball& ball, const oracle::Rational& end) {
    oracle::Ball back = ball;
    for (std::size_t k = 0; k < 3; ++k) back.o[k] += end * back.d[k], back.d[k] = -back.d[k];
    return back.outside(0) > 0 && oracle::between(back, end);
}
inline bool blocked_truth(const TriReq& r, const Config& c) {
    if (r.is_partial && r.triangle.kind == PrimKind::plane) return false;
    if (!is_shadow(r))
        return is_sphere(r, c) ? sphere_truth(r, c) != oracle::SphereRoot::none
                               : flat_crossing(r, c).has_value();
    const oracle::Rational end = oracle::power_of_two(-c.origin_bits);
    if (is_sphere(r, c)) {
        const oracle::Ball ball = ball_of(r, c);
        if (is_opaque(r)) return r.self != r.triangle.prim && is_in_sight(ball, end);
        return r.self == r.triangle.prim ? r.is_inside && ball.outside(0) > 0 : oracle::between(ball, end);
    }
    const auto at = flat_crossing(r, c);
    return at && at->t < end;
}

inline void judge_zeros(const TriRsp& rsp) {
    REQUIRE((rsp.num == 0 && rsp.det == 0 && rsp.prim == 0 && rsp.t == 0 && rsp.u == 0 && rsp.v == 0 &&
             rsp.back == 0 && rsp.cutout == 0));
}
/// `alone` is the answer to the same request without a hit to beat.
inline void judge_sphere(const TriReq& r, const TriRsp& alone, const Config& c) {
    const oracle::SphereRoot meets = sphere_truth(r, c);
    REQUIRE((alone.closer != 0) == (meets != oracle::SphereRoot::none));
    if (!alone.closer) return judge_zeros(alone);
    const oracle::Ball ball = ball_of(r, c);
    const oracle::Rational unit = unit_of(c), t = oracle::Rational(alone.t);
    REQUIRE(alone.back == (meets == oracle::SphereRoot::far));
    REQUIRE(alone.t >= 1);
    if (alone.t < most_t(c)) REQUIRE(oracle::reached(ball, meets, t / unit));
    REQUIRE(!oracle::reached(ball, meets, (t - sphere_excess(ball, c)) / unit));
    REQUIRE((alone.u == 0 && alone.v == 0));
    REQUIRE(alone.prim == r.triangle.prim);
    REQUIRE(alone.num == alone.t);
    REQUIRE(oracle::Rational(big(alone.det)) == unit);
}
inline void judge_flat(const TriReq& r, const TriRsp& alone, const Config& c) {
    const auto at = flat_crossing(r, c);
    REQUIRE((alone.closer != 0) == at.has_value());
    if (!at) return judge_zeros(alone);
    REQUIRE(alone.prim == r.triangle.prim);
    REQUIRE(oracle::Rational(big(alone.num), big(alone.det)) == at->t);
    const int fraction = !leaves(r) ? 0 : c.origin_bits - (is_far(r) ? far_drop : 0);
    REQUIRE((alone.cutout != 0) == ends_at_any(r.kind));
    REQUIRE(big(alone.det) == at->volume * oracle::power_of_two(fraction));
    REQUIRE(alone.t == std::min(oracle::ceil(at->t * unit_of(c)), most_t(c)));
    REQUIRE(alone.back == (side_of_ray(r) > 0));
    const oracle::Int size = oracle::Int(1) << (c.uv_bits() - 1);
    const auto coordinate = [&](const oracle::Rational& x) {
        oracle::Int whole = oracle::floor(x * oracle::power_of_two(c.bary_bits));
        if (c.planes)
            whole = whole < -size ? oracle::Int(-size) : whole >= size ? oracle::Int(size - 1) : whole;
        return whole < 0 ? oracle::Int(whole + 2 * size) : whole;
    };
    REQUIRE(alone.u == coordinate(at->u));
    REQUIRE(alone.v == coordinate(at->v));
}
/// Requires that the answer is the geometry's, and against a hit to beat that of its own fraction.
inline void judge_any(const TriReq& r, const TriRsp& rsp, const Config& c) {
    REQUIRE(rsp.ray == r.ray);
    if (ends_at_any(r.kind)) {
        REQUIRE((rsp.closer != 0) == blocked_truth(r, c));
        if (!rsp.closer || !is_cutout(r)) return judge_zeros(rsp);
        return judge_flat(r, rsp, c);
    }
    TriReq unbeaten = r;
    unbeaten.best = {};
    const TriRsp alone = r.best.found ? tri(unbeaten, c) : rsp;
    if (is_sphere(r, c))
        judge_sphere(r, alone, c);
    else
        judge_flat(r, alone, c);
    if (!r.best.found) return;
    const bool closer =
        alone.closer && oracle::goes_before(oracle::Rational(big(alone.num), big(alone.det)), r.triangle.prim,
                                            oracle::Rational(big(r.best.num), big(r.best.det)), r.best.prim);
    REQUIRE((rsp.closer != 0) == closer);
    if (closer)
        REQUIRE(same(rsp, alone, c));
    else
        judge_zeros(rsp);
}

// ---- Requests.

/// Draws a hit to beat: none, any, exactly as far as its own (as another fraction), or slightly nearer or
/// farther.
inline Best any_best(Draw& draw, const Config& c, const TriRsp& own, std::uint32_t prim) {
    Best best;
    if (draw.coin()) return best;
    const int num_bits = c.num_bits() - 1, det_bits = c.edge_bits() - 1;
    best.found = 1;
    best.num = wide_bits(draw, 1 + draw.below(num_bits)) | 1;
    best.det = wide_bits(draw, 1 + draw.below(det_bits)) | 1;
    const std::uint32_t others[] = {prim, prim - 1, prim + 1, std::uint32_t(draw.natural(c.prim_bits))};
    best.prim = others[draw.below(4)];
    if (!own.closer || draw.below(4) == 0) return best;
    const Int128 factor = draw.between(1, 5);
    const bool fits = own.num * factor >> num_bits == 0 && own.det * factor >> det_bits == 0;
    best.num = fits ? own.num * factor : own.num;
    best.det = fits ? own.det * factor : own.det;
    if (draw.coin()) return best;
    if (draw.coin() && (best.num + 1) >> num_bits == 0)
        ++best.num;
    else if (best.num > 1)
        --best.num;
    return best;
}

/// Clamps x to n bits.
inline std::int32_t clip(std::int64_t x, int n) {
    const std::int64_t most = (std::int64_t(1) << (n - 1)) - 1;
    return std::int32_t(std::clamp(x, -most - 1, most));
}

/// A primitive: spheres often pass near or through the point `near`, on all sides of it.
inline Vec3i scaled(const Vec3i& v, int bits) {
    return {v[0] * (1 << bits), v[1] * (1 << bits), v[2] * (1 << bits)};
}

inline PrimData random_prim(Draw& draw, const Config& c, const Vec3i& near) {
    const int n = c.coord_bits, reach = 1 << draw.below(n - 1);
    PrimData p;
    p.prim = std::uint32_t(draw.natural(c.prim_bits));
    const int kinds = 1 + c.planes + c.spheres, kind = draw.below(kinds);
    p.kind = kind == 0 ? PrimKind::triangle : kind == 1 && c.planes ? PrimKind::plane : PrimKind::sphere;
    if (c.textures && kind == 0 && draw.coin()) p.kind = PrimKind::cutout;
    p.a = draw.coin() ? draw.vector(n) : draw.near(near, reach, n);
    p.b = draw.coin() ? draw.vector(n) : draw.near(p.a, reach, n);
    p.c = draw.coin() ? draw.vector(n) : draw.near(p.b, reach, n);
    if (p.kind != PrimKind::sphere) return p;
    std::uint64_t square = 0;
    for (std::size_t k = 0; k < 3; ++k)
        square += std::uint64_t((std::int64_t(near[k]) - p.a[k]) * (std::int64_t(near[k]) - p.a[k]));
    const std::uint64_t most = (std::uint64_t(1) << (2 * n)) - 1,
                        reach2 = std::uint64_t(reach) * std::uint64_t(reach);
    const std::uint64_t rooms[] = {
        0, 1, most, square, square + 1, square - 1, square / 4, square + reach2, draw.natural(2 * n), reach2};
    const std::uint64_t room = std::min(rooms[draw.below(int(std::size(rooms)))], most);
    p.b = {std::int32_t(std::int64_t(room << (64 - n)) >> (64 - n)),
           std::int32_t(std::int64_t(room >> n << (64 - n)) >> (64 - n)), std::int32_t((room ^ p.prim) & 1)};
    p.c = {};
    return p;
}

/// Most rays aim at a corner, an edge, the inside, or past a sphere's rim. Origins and ends often lie on the
/// primitive.
inline TriReq random_any_req(Draw& draw, const Config& c) {
    const int n = c.coord_bits, b = c.origin_bits;
    TriReq r;
    r.ray = std::uint32_t(draw.natural(c.ray_bits()));
    r.kind = RayKind(draw.below(4));
    const Vec3i from = draw.vector(n);
    r.triangle = random_prim(draw, c, from);
    const PrimData& p = r.triangle;
    r.self = draw.percent(60) ? std::uint32_t(draw.natural(c.prim_bits)) : p.prim;
    r.is_inside = std::uint32_t(draw.coin());
    if (!c.spheres) r.self = r.is_inside = 0;
    const bool is_bounce = r.kind == RayKind::bounce;
    r.is_partial = c.planes && (ends_at_any(r.kind) || (is_bounce && c.horizon)) && draw.percent(30);
    // The target of the ray in units of 2^-B: a weighted point of the corners, or the centre with a random
    // offset.
    Vec3l at{};
    const int weights[][3] = {{4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {2, 2, 0}, {2, 0, 2},
                              {0, 2, 2}, {1, 1, 2}, {2, 1, 1}, {1, 2, 1}, {9, -4, -1}};
    const auto& w = weights[draw.below(10)];
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t sum =
            std::int64_t(w[0]) * p.a[k] + std::int64_t(w[1]) * p.b[k] + std::int64_t(w[2]) * p.c[k];
        at[k] = sum * (std::int64_t(1) << b) / 4;
    }
    if (is_sphere(r, c)) {
        const auto radius = std::int64_t(std::sqrt(double(radius_squared(p, n))) * double(1 << b));
        const std::size_t axis = std::size_t(draw.below(3));
        for (std::size_t k = 0; k < 3; ++k) at[k] = std::int64_t(p.a[k]) * (std::int64_t(1) << b);
        at[axis] += draw.coin() ? radius * (draw.coin() ? 1 : -1)
                                : draw.between(-1, 1) * (radius / draw.between(1, 4));
        if (draw.coin()) at[axis] += draw.between(-2, 2);
    }
    if (is_far(r))
        for (auto& x : at) x >>= far_drop;
    const auto point = [&](const Vec3l& v) {
        return Vec3i{clip(v[0], n + b), clip(v[1], n + b), clip(v[2], n + b)};
    };
    const auto lattice = [&](const Vec3i& v) { return scaled(v, b); };
    r.o = lattice(from);
    if (is_far(r) && draw.coin()) r.o = draw.vector(n + b);
    if (leaves(r) && !draw.percent(10)) {
        if (draw.coin())
            r.o = point(at);   // starts at the primitive itself
        else
            for (auto& x : r.o) x = clip(x + draw.between(0, (1 << b) - 1), n + b);
    }
    if (is_shadow(r)) {
        Vec3i end = draw.coin() ? point(at) : lattice(draw.vector(n));
        const int parts = 1 << draw.below(4), part = draw.between(1, 2 * parts);
        for (std::size_t k = 0; k < 3; ++k) {
            if (draw.coin()) end[k] = clip(r.o[k] + (std::int64_t(end[k]) - r.o[k]) * part / parts, n + b);
            r.d[k] = end[k] - r.o[k];
        }
        if (draw.percent(20)) r.best = any_best(draw, c, {}, p.prim);
        return r;
    }
    r.d = draw.vector(c.dir_bits);
    if (draw.percent(80)) {
        const int shift = draw.below(b + 3), factor = draw.below(4) == 0 ? -1 : 1;
        std::int64_t longest = 1;
        for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, std::abs(at[k] - r.o[k]));
        int cut = 0;
        while (longest >> cut >= std::int64_t(1) << (c.dir_bits - 1)) ++cut;
        if (draw.coin()) cut = std::max(cut, shift);
        for (std::size_t k = 0; k < 3; ++k) r.d[k] = clip(factor * ((at[k] - r.o[k]) >> cut), c.dir_bits);
    }
    r.best = any_best(draw, c, tri(r, c), p.prim);
    return r;
}

}   // namespace rayclock::test
