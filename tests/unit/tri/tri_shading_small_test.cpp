// tri of a shading chip at widths so small that every operand can be tested: every ray with two fraction bits
// and every sphere. 64-bit integers decide each case by counting where the path meets the sphere.
#include <atomic>

#include <tbb/parallel_for.h>

#include "tests/support/cases/any_cases.hpp"
#include "tests/support/cases/small.hpp"

namespace rayclock::test::tri_shading_small_test {

using namespace rayclock;

namespace {

/// N = 2, M = 3, B = 2: 64 lattice points, 4096 origins of bounces, radii squared 0 .. 15.
Config tiny() {
    Config c = small_format(2, 3, 3, 2, 1);
    c.name = "tiny";
    c.shading = c.spheres = c.planes = 1;
    c.origin_bits = 2;
    c.bary_bits = 2;
    c.tri_queue = 64;
    return c;
}

/// The `number`-th request about the sphere: origin, direction, then radius. The centre is in the middle or
/// at a corner. `number` also selects whether the sphere is seen from inside, is the ray's own, and contains
/// the ray.
struct Space {
    RayKind kind;
    Vec3i centre;
    bool leaves() const { return kind == RayKind::bounce || kind == RayKind::away; }   // a surface
    std::uint64_t size(const Config& c) const {
        const int o = leaves() ? c.origin_width() : c.coord_bits,
                  d = kind == RayKind::shadow ? c.origin_width() : c.dir_bits;
        return std::uint64_t(1) << (3 * o + 3 * d + 2 * c.coord_bits + (kind == RayKind::camera ? 1 : 3));
    }
    TriReq at(std::uint64_t number, const Config& c) const {
        const auto take = [&](int bits) {
            const std::uint64_t part = number & ((std::uint64_t(1) << bits) - 1);
            number >>= bits;
            return part;
        };
        TriReq r;
        r.kind = kind;
        r.triangle.kind = PrimKind::sphere;
        r.triangle.prim = 5;
        r.triangle.a = centre;
        const std::uint64_t room = take(2 * c.coord_bits);
        for (std::size_t k = 0; k < 2; ++k)
            r.triangle.b[k] = vector_of(room >> (k * std::size_t(c.coord_bits)), c.coord_bits)[0] ^
                              (1 << (c.coord_bits - 1));
        for (std::size_t k = 0; k < 2; ++k)
            r.triangle.b[k] =
                std::int32_t(std::uint32_t(r.triangle.b[k]) << (32 - c.coord_bits)) >> (32 - c.coord_bits);
        r.d = vector_of(take(3 * (kind == RayKind::shadow ? c.origin_width() : c.dir_bits)),
                        kind == RayKind::shadow ? c.origin_width() : c.dir_bits);
        r.o = vector_of(take(3 * (leaves() ? c.origin_width() : c.coord_bits)),
                        leaves() ? c.origin_width() : c.coord_bits);
        if (!leaves())
            for (auto& x : r.o) x *= 1 << c.origin_bits;
        if (kind == RayKind::shadow)   // so far `d` was the end
            for (std::size_t k = 0; k < 3; ++k) r.d[k] -= r.o[k];
        r.triangle.b[2] = std::int32_t(take(1));
        if (kind != RayKind::camera) r.self = take(1) ? 5 : 4, r.is_inside = std::uint32_t(take(1));
        return r;
    }
};

/// The correct answer: where along the path the squared distance, a polynomial, is below the squared radius.
struct Truth {
    bool met, far;
};
Truth truth(const TriReq& r, const Config& c) {
    const std::int64_t unit = std::int64_t(1) << c.origin_bits;
    std::int64_t b = 0, a = 0, start = -std::int64_t(radius_squared(r.triangle, c.coord_bits)) * unit * unit;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t s = r.o[k] - r.triangle.a[k] * unit;
        b += s * r.d[k], a += std::int64_t(r.d[k]) * r.d[k], start += s * s;
    }
    // f(x) = a x^2 + 2 b x + start: the squared distance minus the squared radius after x times d, all times
    // 4^B.
    const auto f = [&](std::int64_t x) { return a * x * x + 2 * b * x + start; };
    const bool own = r.kind != RayKind::camera && r.self == r.triangle.prim;
    const bool dips = a > 0 && b < 0 && a * start <= b * b;   // falls to 0 or below somewhere ahead
    if (is_opaque(r)) {   // met only from outside; a shadow ray is seen from its point
        const bool between = start > 0 ? dips && -b < a : start < 0 || b < 0;
        return {!own && (r.kind == RayKind::shadow ? f(1) > 0 && between : start > 0 && dips), false};
    }
    if (r.kind == RayKind::shadow) {
        if (own) return {r.is_inside && start > 0, false};
        if (start > 0) return {f(1) < 0 || (dips && -b < a), false};
        return {f(1) > 0 && (start < 0 || b < 0), false};
    }
    if (own && !r.is_inside) return {false, false};
    if (start > 0) return {dips, own};
    return {start < 0 ? a > 0 : b < 0, true};
}

/// Returns true for a correct distance. t is the largest only if it saturates; otherwise it lies between the
/// crossing and its upper bound, both computed from f in 128 bits.
bool right_distance(const TriReq& r, const TriRsp& rsp, bool far, const Config& c) {
    const oracle::Ball ball = ball_of(r, c);
    const oracle::SphereRoot which = far ? oracle::SphereRoot::far : oracle::SphereRoot::near;
    const oracle::Rational unit = unit_of(c);
    return (rsp.t == most_t(c) || oracle::reached(ball, which, oracle::Rational(rsp.t) / unit)) &&
           !oracle::reached(ball, which, (oracle::Rational(rsp.t) - sphere_excess(ball, c)) / unit);
}

struct Count {
    std::uint64_t met = 0, wrong = 0, measured = 0;
    void add(const TriReq& r, const TriRsp& rsp, const Config& c, std::uint64_t number) {
        const Truth right = truth(r, c);
        met += right.met;
        wrong += right.met != (rsp.closer != 0);
        if (ends_at_any(r.kind)) {
            wrong += rsp.t != 0 || rsp.num != 0 || rsp.back != 0;
        } else if (rsp.closer) {
            wrong += rsp.back != right.far || rsp.num != rsp.t;
            if (number % 499 != 0) return;
            ++measured;
            wrong += !right_distance(r, rsp, right.far, c);
        }
    }
};
Count try_model(const Config& config, const Space& space, std::uint64_t step) {
    std::atomic<std::uint64_t> met{0}, wrong{0}, measured{0};
    tbb::parallel_for(tbb::blocked_range<std::uint64_t>(0, space.size(config) / step, 1 << 14),
                      [&](const auto& range) {
                          Count count;
                          for (std::uint64_t i = range.begin(); i < range.end(); ++i) {
                              const TriReq r = space.at(i * step, config);
                              count.add(r, tri(r, config), config, i);
                          }
                          met += count.met, wrong += count.wrong, measured += count.measured;
                      });
    return {met, wrong, measured};
}
Count try_rtl(const Config& config, const Space& space, std::uint64_t step) {
    Rtl<TriUnit> rtl{config};
    Count count;
    std::uint64_t next = 0, answered = 0;
    pour(
        rtl, space.size(config) / step, [&] { return space.at(next++ * step, config); },
        [&](const TriReq& r, const TriRsp& rsp) {
            count.add(r, rsp, config, 1 + answered);
            count.wrong += !same(rsp, tri(r, config), config);
            ++answered;
        });
    return count;
}
const Vec3i middle{0, 0, 0}, corner{-2, 1, -2};

}   // namespace

TEST_CASE("the integer judge of small spheres agrees with exact fractions", "[any][small]") {
    const Config config = tiny();
    const RayKind kind = GENERATE(RayKind::camera, RayKind::bounce, RayKind::shadow, RayKind::away);
    const Space space{kind, corner};
    for (std::uint64_t i = 0, n = space.size(config); i < n; i += n / 5003 + 1) {
        const TriReq r = space.at(i, config);
        CAPTURE(int(kind), i);
        REQUIRE(truth(r, config).met == (ends_at_any(kind)
                                             ? blocked_truth(r, config)
                                             : sphere_truth(r, config) != oracle::SphereRoot::none));
        if (!ends_at_any(kind) && truth(r, config).met)
            REQUIRE(truth(r, config).far == (sphere_truth(r, config) == oracle::SphereRoot::far));
    }
}

TEST_CASE("tri is right for every camera ray and sphere of 64 points", "[tri][any][small][long]") {
    const Config config = tiny();
    for (const Vec3i& centre : {middle, corner}) {
        const Space space{RayKind::camera, centre};
        const Count model = try_model(config, space, 1), rtl = try_rtl(config, space, 1);
        REQUIRE(model.wrong == 0);
        REQUIRE(rtl.wrong == 0);
        REQUIRE(rtl.met > 20000);
        REQUIRE(model.measured > 50);
    }
}

TEST_CASE("tri is right for secondary rays and spheres of 64 points", "[tri][any][small]") {
    const Config config = tiny();
    for (const RayKind kind : {RayKind::bounce, RayKind::shadow, RayKind::away}) {
        const Space space{kind, kind == RayKind::bounce ? corner : middle};
        const Count model = try_model(config, space, 61), rtl = try_rtl(config, space, 1009);
        CAPTURE(int(kind));
        REQUIRE(model.wrong == 0);
        REQUIRE(rtl.wrong == 0);
        REQUIRE(rtl.met > 1000);
    }
}

TEST_CASE("model of tri is right for every secondary ray and sphere of 64 points",
          "[tri][any][small][slow]") {
    const Config config = tiny();
    for (const RayKind kind : {RayKind::bounce, RayKind::shadow, RayKind::away})
        for (const Vec3i& centre : {middle, corner}) {
            const Count count = try_model(config, Space{kind, centre}, 1);
            CAPTURE(int(kind));
            REQUIRE(count.wrong == 0);
            REQUIRE(count.met > 1000000);
        }
}

}   // namespace rayclock::test::tri_shading_small_test
