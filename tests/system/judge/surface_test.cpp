// The oracle itself: compares its triangle test with elimination in fractions, and its search with brute
// force in 256 bits.
#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/support/oracle/fractions.hpp"
#include "tests/support/cases/draw.hpp"
#include "tests/support/geometry/exact.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Returns triangles of all sizes around a place, many with shared corners, some without area.
std::vector<oracle::Corners> random_triangles(Draw& draw, int bits, int count) {
    std::vector<oracle::Corners> triangles;
    for (int i = 0; i < count; ++i) {
        const int reach = 1 << draw.below(bits - 1);
        oracle::Corners t;
        t.a = !triangles.empty() && draw.coin() ? triangles[std::size_t(draw.below(int(triangles.size())))].b
                                                : draw.vector(bits);
        t.b = draw.near(t.a, reach, bits);
        t.c = draw.below(8) == 0 ? t.a : draw.near(t.b, reach, bits);
        triangles.push_back(t);
    }
    return triangles;
}

struct RandomRay {
    Vec3i o, d;
};

/// Half of the rays aim at a corner, an edge's middle or inside a triangle, with a direction that needs no
/// rounding.
RandomRay random_ray(Draw& draw, int bits, int dir_bits, const std::vector<oracle::Corners>& triangles) {
    RandomRay ray{draw.vector(bits), draw.vector(dir_bits)};
    if (draw.coin()) return ray;
    const oracle::Corners& t = triangles[std::size_t(draw.below(int(triangles.size())))];
    const int weights[][3] = {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
    const auto& w = weights[draw.below(6)];
    const int most = (1 << (dir_bits - 1)) - 1;
    for (std::size_t k = 0; k < 3; ++k)
        ray.d[k] = std::clamp(
            (w[0] * (t.a[k] - ray.o[k]) + w[1] * (t.b[k] - ray.o[k]) + w[2] * (t.c[k] - ray.o[k])) / 2,
            -most - 1, most);
    return ray;
}

}   // namespace

TEST_CASE("the oracle's triangle test is what elimination in fractions finds") {
    const int bits = GENERATE(3, 12, 16, 20), dir_bits = bits == 20 ? 22 : bits + 2;
    Draw draw{unsigned(bits)};
    int hits = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto triangles = random_triangles(draw, bits, 1);
        const RandomRay ray = random_ray(draw, bits, dir_bits, triangles);
        const oracle::Corners& t = triangles[0];
        const oracle::ExactHit hit = oracle::exact_hit(ray.o, ray.d, t, 5);
        const auto truth = oracle::crossing(oracle::point(ray.o), oracle::point(ray.d), oracle::point(t.a),
                                            oracle::point(t.b), oracle::point(t.c));
        REQUIRE((hit.primitive == 5) == truth.has_value());
        if (!truth) continue;
        ++hits;
        REQUIRE(oracle::Rational(oracle::Int(std::int64_t(hit.num)), oracle::Int(std::int64_t(hit.den))) ==
                truth->t);
        // The ray enters where it leaves the side of the normal.
        const auto a = oracle::triple<Int>(t.a);
        const auto normal =
            oracle::area(oracle::way(a, oracle::triple<Int>(t.b)), oracle::way(a, oracle::triple<Int>(t.c)));
        REQUIRE((hit.sense > 0) == (oracle::volume<Int>(oracle::triple<Int>(ray.d), normal) < 0));
    }
    REQUIRE(hits > 200);
}

TEST_CASE("the oracle's search skips no triangle that a ray meets, and finds the closest") {
    const int bits = GENERATE(4, 12, 18, 20), dir_bits = bits == 20 ? 22 : bits + 2;
    Draw draw{unsigned(100 + bits)};
    std::vector<std::uint32_t> found;
    std::size_t hits = 0, looked = 0;
    for (int round = 0; round < 12; ++round) {
        const auto triangles = random_triangles(draw, bits, 1 + draw.below(120));
        const oracle::Surface surface(triangles);
        const ExactScene brute(triangles);
        for (int i = 0; i < 100; ++i) {
            const RandomRay ray = random_ray(draw, bits, dir_bits, triangles);
            const ExactHit truth = brute.closest(ray.o, ray.d);
            const oracle::ExactHit hit = surface.closest(ray.o, ray.d);
            REQUIRE(hit.primitive == truth.primitive);
            if (truth.primitive != no_primitive) {
                REQUIRE(Int(std::int64_t(hit.num)) == truth.num);
                REQUIRE(Int(std::int64_t(hit.den)) == truth.den);
            }
            surface.candidates(ray.o, ray.d, found);
            looked += found.size();
            std::size_t met = 0, met_there = 0;
            for (std::size_t t = 0; t < triangles.size(); ++t)
                met += oracle::cross<Int, Int>(ray.o, ray.d, triangles[t]).has_value();
            for (const std::uint32_t t : found)
                met_there += oracle::exact_hit(ray.o, ray.d, triangles[t], t).primitive == t;
            REQUIRE(met_there == met);
            hits += met;
        }
    }
    REQUIRE(hits > 100);
    REQUIRE(looked < 12 * 100 * 60);   // the search skips most triangles
}
