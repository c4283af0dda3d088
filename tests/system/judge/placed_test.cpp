// The oracle of two levels: the instance that a ray meets, by brute force in arbitrary fractions, from the
// stated rule of rounding alone.
#include <cmath>

#include <catch2/catch.hpp>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "sim/judge/oracle/placed.hpp"
#include "tests/support/cases/draw.hpp"
#include "tests/support/oracle/fractions.hpp"

namespace rayclock::test::placed_test {

using oracle::PlacedRay;
using oracle::Rational;
using test::Draw;

namespace {

struct Format {
    int coord_bits, dir_bits, origin_bits;
};

/// Meshes, the last about `small` steps large, and instances whose rows sum to at most 1: some at full size,
/// some tiny, some sheared.
struct World {
    std::vector<std::vector<oracle::Corners>> meshes;
    std::vector<oracle::SolidPlace> places;
    int frac;
};

World random_world(Draw& draw, const Format& f, int small = 6) {
    World w{{}, {}, f.coord_bits + 3};
    const std::int64_t one = std::int64_t(1) << w.frac;
    for (int m = 0; m < 3; ++m) {
        std::vector<oracle::Corners>& mesh = w.meshes.emplace_back();
        const Vec3i middle = draw.vector(f.coord_bits - 2);   // the centre of the last mesh, which is small
        for (int i = 0; i < 6; ++i) {
            const int reach = m == 2 ? small : 1 << draw.below(f.coord_bits - 1), bits = f.coord_bits - 1;
            oracle::Corners t;
            t.a = m == 2 ? draw.near(middle, reach, bits) : draw.vector(bits);
            t.b = draw.near(t.a, reach, bits);
            t.c = draw.below(8) == 0 ? t.a : draw.near(t.a, reach, bits);
            mesh.push_back(t);
        }
    }
    std::uint32_t first = 0;
    for (int p = 0; p < 8; ++p) {
        oracle::SolidPlace place;
        place.mesh = std::uint32_t(draw.below(3)), place.first = first;
        first += 6;
        for (std::size_t i = 0; i < 3; ++i) {
            const int size = draw.below(3);   // of the entries off the diagonal
            for (std::size_t k = 0; k < 3; ++k)
                place.a[3 * i + k] = i == k      ? one / (size == 0 ? 1 : 2)
                                     : size == 0 ? 0
                                                 : one / 4 / (1 + draw.below(9));
            if (draw.coin())
                for (std::size_t k = 0; k < 3; ++k) place.a[3 * i + k] = -place.a[3 * i + k];
            place.b[i] = std::int64_t(draw.vector(f.coord_bits - 2)[0]) * one + draw.below(1 << 14);
        }
        if (draw.below(4) == 0)
            for (std::int64_t& entry : place.a) entry = entry / 29 + draw.below(3);
        if (p % 4 == 3) {   // at the same place as the previous one, so that common parts are hit at once
            const std::uint32_t first_here = place.first;
            place = w.places.back(), place.first = first_here;
        }
        w.places.push_back(place);
    }
    return w;
}

oracle::PlacedSolids solids_of(const World& w, const Format& f) {
    std::vector<oracle::Solids> meshes;
    for (const auto& mesh : w.meshes) {
        std::vector<oracle::Solid> solids;
        for (const oracle::Corners& t : mesh) solids.push_back({oracle::Solid::Shape::triangle, t, {}, 0});
        meshes.emplace_back(solids);
    }
    return {std::move(meshes), w.places, w.frac, f.coord_bits, f.dir_bits};
}

/// Computes floor(y + 1/2).
Vec3i rounded(const oracle::SolidPlace& place, const Vec3i& v, const Rational& shift, int frac) {
    Vec3i out{};
    for (std::size_t i = 0; i < 3; ++i) {
        Rational y = Rational(place.b[i]) * shift;
        for (std::size_t k = 0; k < 3; ++k) y += Rational(place.a[3 * i + k]) * v[k];
        out[i] = std::int32_t(oracle::floor(y * oracle::power_of_two(-frac) + Rational(1, 2)));
    }
    return out;
}

struct Truth {
    std::uint32_t primitive = no_primitive;
    Rational t = 0;
};

/// Tests every triangle of every instance. Hits beyond `end` do not count; 0 means no limit.
Truth truth(const World& w, const PlacedRay& ray, const Rational& end) {
    Truth best;
    for (std::uint32_t p = 0; p < w.places.size(); ++p) {
        const oracle::SolidPlace& place = w.places[p];
        oracle::SolidRay seen = ray.at_home;
        if (p != ray.home) {
            seen = ray.ray;
            seen.origin = rounded(place, ray.ray.origin, oracle::power_of_two(seen.frac), w.frac);
            seen.direction = rounded(place, ray.ray.direction, 0, w.frac);
        }
        const oracle::Int unit = oracle::Int(1) << seen.frac;
        const auto scaled = [&](const Vec3i& v) {
            return oracle::Point{v[0] * unit, v[1] * unit, v[2] * unit};
        };
        for (std::uint32_t i = 0; i < 6; ++i) {
            const oracle::Corners& c = w.meshes[place.mesh][i];
            const auto hit = oracle::crossing(oracle::point(seen.origin), scaled(seen.direction), scaled(c.a),
                                              scaled(c.b), scaled(c.c));
            if (!hit || (end != 0 && hit->t >= end)) continue;
            if (best.primitive == no_primitive ||
                oracle::goes_before(hit->t, place.first + i, best.t, best.primitive))
                best = {place.first + i, hit->t};
        }
    }
    return best;
}

Vec3i towards_corner(Draw& draw, const World& w, const Format& f, const oracle::SolidRay& from) {
    const oracle::SolidPlace& place = w.places[std::size_t(draw.below(int(w.places.size())))];
    const oracle::Corners& t = w.meshes[place.mesh][std::size_t(draw.below(6))];
    glm::dmat3 a;
    glm::dvec3 at;
    const double u = draw.below(5) / 4.0, v = (1 - u) * draw.below(5) / 4.0;
    for (std::size_t i = 0; i < 3; ++i) {
        at[int(i)] =
            t.a[i] + u * (t.b[i] - t.a[i]) + v * (t.c[i] - t.a[i]) - std::ldexp(double(place.b[i]), -w.frac);
        for (std::size_t k = 0; k < 3; ++k)
            a[int(k)][int(i)] = std::ldexp(double(place.a[3 * i + k]), -w.frac);
    }
    glm::dvec3 d = glm::inverse(a) * at;
    for (int k = 0; k < 3; ++k) d[k] -= std::ldexp(double(from.origin[std::size_t(k)]), -from.frac);
    const double longest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z), 1e-9}),
                 full = std::ldexp(draw.below(8) == 0 ? 0.1 : 0.9, f.dir_bits - 1);
    Vec3i out{};
    for (std::size_t k = 0; k < 3; ++k) out[k] = std::int32_t(std::round(d[int(k)] * full / longest));
    return out;
}

/// Draws a ray to a corner, an edge or the inside of a triangle in an instance's space, or anywhere;
/// sometimes a short one.
PlacedRay random_ray(Draw& draw, const World& w, const Format& f) {
    PlacedRay ray;
    ray.ray.frac = draw.coin() ? f.origin_bits : 0;
    const int bits = f.coord_bits - 1;
    for (std::size_t k = 0; k < 3; ++k)
        ray.ray.origin[k] = draw.vector(bits)[0] * (1 << ray.ray.frac) + (ray.ray.frac ? draw.below(4) : 0);
    ray.ray.direction = draw.vector(draw.below(6) == 0 ? f.dir_bits / 2 : f.dir_bits);
    if (draw.below(8) > 0) ray.ray.direction = towards_corner(draw, w, f, ray.ray);
    if (draw.below(3) == 0) {
        ray.home = std::uint32_t(draw.below(int(w.places.size())));
        ray.at_home = ray.ray;
        ray.at_home.origin = oracle::placed_point(w.places[ray.home], ray.ray.origin, ray.ray.frac, w.frac);
        ray.at_home.direction = oracle::placed_direction(w.places[ray.home], ray.ray.direction, w.frac);
        for (std::size_t k = 0; k < 3; ++k) ray.at_home.origin[k] += draw.below(5) - 2;
    }
    return ray;
}

}   // namespace

TEST_CASE("the oracle of two levels is what fractions find in every instance", "[levels]") {
    const Format f =
        GENERATE(values<Format>({{12, 12, 10}, {12, 24, 12}, {16, 18, 12}, {18, 20, 12}, {20, 18, 10}}));
    CAPTURE(f.coord_bits, f.dir_bits);
    Draw draw{unsigned(f.coord_bits * 100 + f.dir_bits)};
    int hits = 0, blocked = 0;
    for (int n = 0; n < 12; ++n) {
        const World w = random_world(draw, f);
        const oracle::PlacedSolids solids = solids_of(w, f);
        for (int i = 0; i < 60; ++i) {
            const PlacedRay ray = random_ray(draw, w, f);
            const Truth right = truth(w, ray, 0);
            const oracle::PlacedHit found = solids.nearest(ray);
            const std::uint32_t primitive = found.place == PlacedRay::nowhere
                                                ? no_primitive
                                                : w.places[found.place].first + found.hit.primitive;
            REQUIRE(primitive == right.primitive);
            CHECK((solids.meets_any(ray) != PlacedRay::nowhere) == (right.primitive != no_primitive));
            hits += right.primitive != no_primitive;
            if (right.primitive == no_primitive) continue;
            CHECK(solids.place_of(primitive) == found.place);
            CHECK(Rational(oracle::Int(found.hit.num), oracle::Int(found.hit.den)) == right.t);
            const Truth before = truth(w, ray, oracle::power_of_two(-4));
            const bool is_blocked = solids.blocks(ray, 4) != PlacedRay::nowhere;
            CHECK(is_blocked == (before.primitive != no_primitive));
            blocked += is_blocked;
        }
    }
    CHECK(hits > 100);
    CHECK(blocked < hits);
}

TEST_CASE("a small mesh is found where rounding has brought the ray to it", "[levels]") {
    const Format f = GENERATE(values<Format>({{16, 12, 12}, {20, 18, 10}}));
    Draw draw{unsigned(f.coord_bits)};
    int hits = 0;
    for (int n = 0; n < 60; ++n) {   // smaller than the shift of a ray by rounding
        World w = random_world(draw, f, 2);
        for (oracle::SolidPlace& place : w.places) place.mesh = 2;
        const oracle::PlacedSolids solids = solids_of(w, f);
        for (int i = 0; i < 60; ++i) {
            PlacedRay ray;
            ray.ray.origin = draw.vector(f.coord_bits - 1);
            ray.ray.direction = towards_corner(draw, w, f, ray.ray);
            const Truth right = truth(w, ray, 0);
            CHECK((solids.meets_any(ray) != PlacedRay::nowhere) == (right.primitive != no_primitive));
            hits += right.primitive != no_primitive;
        }
    }
    CHECK(hits > 100);
}

}   // namespace rayclock::test::placed_test
