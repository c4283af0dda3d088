// tri at small widths, for every ray and triangle of the lattice. Judged by signed volumes in plain integers.
// These are judged by the fractions of fractions.hpp.
#include <set>

#include <tbb/parallel_for.h>

#include "model/unit/tri/tri.hpp"
#include "tests/support/cases/small.hpp"
#include "tests/support/cases/tri_cases.hpp"

namespace rayclock::test::tri_small_test {

using namespace rayclock;

namespace {

std::int64_t volume(const Vec3i& p, const Vec3i& q, const Vec3i& r) {
    return std::int64_t(p[0]) * (q[1] * r[2] - q[2] * r[1]) +
           std::int64_t(p[1]) * (q[2] * r[0] - q[0] * r[2]) +
           std::int64_t(p[2]) * (q[0] * r[1] - q[1] * r[0]);
}
Vec3i minus(const Vec3i& a, const Vec3i& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Six times the volume of d and the edge p q as seen from o: the side on which the ray passes the edge. As o
/// moves by (eps, eps^2, eps^3) it changes linearly, since eps x eps = 0. So its sign is that of the first
/// nonzero one of these four.
int side(const Vec3i& o, const Vec3i& d, const Vec3i& p, const Vec3i& q, std::int64_t& here) {
    here = volume(d, minus(p, o), minus(q, o));
    if (here != 0) return here > 0 ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
        Vec3i moved = o;
        ++moved[k];
        const std::int64_t there = volume(d, minus(p, moved), minus(q, moved));
        if (there != 0) return there > 0 ? 1 : -1;
    }
    return 0;
}

/// With A = a - o and so on, t d = w A + u B + v C. So u = vol(d, C, A) / S, v = vol(d, A, B) / S, w = vol(d,
/// B, C) / S and t = vol(A, B, C) / S, where S = vol(d, b - a, c - a) is the sum of the three.
TriRsp truth(const TriReq& req, const Config& config) {
    const Vec3i &a = req.triangle.a, &b = req.triangle.b, &c = req.triangle.c;
    const std::uint32_t prim = req.triangle.prim;
    TriRsp rsp;
    rsp.ray = req.ray;
    std::int64_t u = 0, v = 0, w = 0;
    const std::int64_t s = volume(req.d, minus(b, a), minus(c, a)), sign = s > 0 ? 1 : -1;
    const std::int64_t num = sign * volume(minus(a, req.o), minus(b, req.o), minus(c, req.o)), det = sign * s;
    if (s == 0 || num <= 0) return rsp;
    if (side(req.o, req.d, c, a, u) != sign || side(req.o, req.d, a, b, v) != sign ||
        side(req.o, req.d, b, c, w) != sign)
        return rsp;
    if (req.best.found) {
        const Int128 mine = num * req.best.det, theirs = req.best.num * det;
        if (mine > theirs || (mine == theirs && prim > req.best.prim)) return rsp;
    }
    rsp.closer = 1;
    rsp.num = num;
    rsp.det = det;
    rsp.prim = prim;
    const std::int64_t t = ((num << (config.dir_bits - 1 + config.t_frac_bits)) + det - 1) / det;
    rsp.t = std::uint32_t(std::min<std::int64_t>(t, (1 << config.t_bits()) - 1));
    rsp.u = std::uint32_t((sign * u << config.bary_bits) / det);
    rsp.v = std::uint32_t((sign * v << config.bary_bits) / det);
    return rsp;
}

bool equal(const TriRsp& a, const TriRsp& b) {
    return std::tie(a.ray, a.closer, a.num, a.det, a.prim, a.t, a.u, a.v) ==
           std::tie(b.ray, b.closer, b.num, b.det, b.prim, b.t, b.u, b.v);
}

struct Count {
    std::uint64_t hits = 0, wrong = 0;
};
Count try_rtl(const Config& config, std::uint64_t first, std::uint64_t last) {
    Rtl<TriUnit> rtl{config};
    Count count;
    pour(
        rtl, last - first, [&] { return tri_request(first++, config); },
        [&](const TriReq& req, const TriRsp& rsp) {
            const TriRsp right = truth(req, config);
            count.hits += right.closer;
            count.wrong += !equal(rsp, right);
        });
    return count;
}
Count try_model(const Config& config, std::uint64_t first, std::uint64_t last) {
    std::atomic<std::uint64_t> hits{0}, wrong{0};
    tbb::parallel_for(tbb::blocked_range<std::uint64_t>(first, last, 1 << 16), [&](const auto& range) {
        Count count;
        for (std::uint64_t i = range.begin(); i < range.end(); ++i) {
            const TriReq req = tri_request(i, config);
            const TriRsp right = truth(req, config);
            count.hits += right.closer;
            count.wrong += !equal(tri(req, config), right);
        }
        hits += count.hits;
        wrong += count.wrong;
    });
    return {hits, wrong};
}

// N = 1: the corners of a cube. N = 2: 64 points. M = 2: components -2 .. 1.
const Config cube = small_format(1, 2, 3, 1, 1), lattice = small_format(2, 2, 3, 1, 1);

/// Returns one request for each possible fraction num / det of a hit.
std::vector<TriReq> fractions(const Config& config) {
    std::set<std::pair<std::int64_t, std::int64_t>> seen;
    std::vector<TriReq> all;
    for (std::uint64_t i = 0; i < tri_requests(config); ++i) {
        const TriReq req = tri_request(i, config);
        const TriRsp right = truth(req, config);
        if (right.closer && seen.emplace(right.num, right.det).second) all.push_back(req);
    }
    return all;
}

}   // namespace

TEST_CASE("signed volumes agree with exact fractions", "[tri][small]") {
    for (const Config& config : {cube, lattice})
        for (std::uint64_t i = 0, n = tri_requests(config); i < n; i += n / 20011 + 1) {
            CAPTURE(config.name, i);
            const TriReq req = tri_request(i, config);
            judge(req, truth(req, config), config);
        }
}

TEST_CASE("tri is right for every ray and triangle on a cube's corners", "[tri][small]") {
    const Count model = try_model(cube, 0, tri_requests(cube)), rtl = try_rtl(cube, 0, tri_requests(cube));
    REQUIRE(model.wrong == 0);
    REQUIRE(rtl.wrong == 0);
    REQUIRE(rtl.hits > 1000);
}

TEST_CASE("tri is right for every fraction of a hit against every hit to beat", "[tri][small]") {
    Rtl<TriUnit> rtl{cube};
    std::vector<TriReq> requests;
    for (TriReq req : fractions(cube))
        for (std::int64_t num = 1; num < 1 << (cube.num_bits() - 1); ++num)
            for (std::int64_t det = 1; det < 1 << (cube.edge_bits() - 1); ++det)
                for (const std::uint32_t prim : {4u, 5u, 6u}) {
                    req.best = {1, num, det, prim};
                    requests.push_back(req);
                }
    REQUIRE(requests.size() > 5000);
    std::size_t next = 0, wrong = 0;
    pour(
        rtl, requests.size(), [&] { return requests[next++]; },
        [&](const TriReq& req, const TriRsp& rsp) {
            const TriRsp right = truth(req, cube);
            wrong += !equal(rsp, right) || !equal(tri(req, cube), right);
        });
    REQUIRE(wrong == 0);
}

TEST_CASE("model of tri is right for every ray and triangle of 64 points", "[tri][small][slow]") {
    const Count count = try_model(lattice, 0, tri_requests(lattice));
    REQUIRE(count.wrong == 0);
    REQUIRE(count.hits > 1000000);
}

TEST_CASE("RTL of tri is right for every ray and triangle of 64 points with one corner in the middle",
          "[tri][small][slow]") {
    // a = (0, -1, 0): differences to it have both signs on every axis.
    const std::uint64_t a = 2 + 4 * 1 + 16 * 2, block = tri_requests(lattice) / 64;
    REQUIRE(tri_request(a * block, lattice).triangle.a == Vec3i{0, -1, 0});
    const Count count = try_rtl(lattice, a * block, (a + 1) * block);
    REQUIRE(count.wrong == 0);
    REQUIRE(count.hits > 10000);
}

}   // namespace rayclock::test::tri_small_test
