// Secondary rays: no surface shadows itself, and no light leaks through a shell of any thickness.
#include <catch2/catch.hpp>

#include "model/unit/tri/origin.hpp"
#include "sim/judge/oracle/visibility.hpp"
#include "sim/explore/stress/shadow_scenes.hpp"
#include "sim/explore/stress/shadows.hpp"

using namespace rayclock;
using oracle::Corners;
using oracle::Visibility;
using Method = OriginScheme::Method;

namespace {

void check_scheme(std::uint64_t rays, unsigned seed, const OriginScheme& scheme) {
    for (const ShadowScene& scene : shadow_scenes()) {
        for (const int bits : {12, 14, 16, 18, 20}) {
            const ShadowCounts c = shadow_counts(scene.make(bits), bits, seed, rays, scheme);
            CAPTURE(scene.name, bits, seed, scheme.name());
            REQUIRE(c.rays == rays);
            REQUIRE(c.false_shadows == 0);
            REQUIRE(c.light_leaks == 0);
            REQUIRE(c.either * 100 <= rays);   // the judge gives verdicts
        }
    }
}

/// A prism over an L shape: closed, with a concave edge and concave corners. It is the union of two boxes.
struct Prism {
    bool within, outside;   ///< strictly
};
Prism in_prism(const Vec3i& p) {
    const std::array<Vec3i, 2> boxes[] = {{{{-3, -2, -1}, {3, 0, 2}}}, {{{-3, -2, -1}, {0, 3, 2}}}};
    Prism in{false, true};
    for (const auto& [lo, hi] : boxes) {
        bool within = true, touched = true;
        for (std::size_t k = 0; k < 3; ++k) {
            within = within && lo[k] < p[k] && p[k] < hi[k];
            touched = touched && lo[k] <= p[k] && p[k] <= hi[k];
        }
        in.within = in.within || within;
        in.outside = in.outside && !touched;
    }
    return in;
}
std::vector<Corners> prism() {
    const int ring[6][2] = {{-3, -2}, {3, -2}, {3, 0}, {0, 0}, {0, 3}, {-3, 3}};
    std::vector<Corners> mesh;
    const auto at = [&](int i, int z) { return Vec3i{ring[i % 6][0], ring[i % 6][1], z}; };
    for (int i = 0; i < 6; ++i) {
        mesh.push_back({at(i, -1), at(i + 1, -1), at(i + 1, 2)});
        mesh.push_back({at(i, -1), at(i + 1, 2), at(i, 2)});
    }
    for (const auto& [a, b, c] :
         // A fan from the concave corner.
         {std::array{3, 4, 5}, std::array{3, 5, 0}, std::array{3, 0, 1}, std::array{3, 1, 2}}) {
        mesh.push_back({at(a, 2), at(b, 2), at(c, 2)});
        mesh.push_back({at(c, -1), at(b, -1), at(a, -1)});
    }
    return mesh;
}
/// Returns the prism with shells around it: one step away outside, less inside.
std::vector<Corners> shells() {
    std::vector<Corners> mesh = prism();
    for (const int r : {8, 9})
        for (int octant = 0; octant < 8; ++octant)
            mesh.push_back(
                {{octant & 1 ? r : -r, 0, 0}, {0, octant & 2 ? r : -r, 0}, {0, 0, octant & 4 ? r : -r}});
    return mesh;
}

PrimData prim_of(const Corners& t) { return {t.a, t.b, t.c, 0}; }

}   // namespace

TEST_CASE("no false shadow and no light leak from points of the surface", "[shadows]") {
    for (const int frac_bits : {2, 6, 16})
        check_scheme(700, unsigned(frac_bits), {Method::surface, frac_bits});
}

TEST_CASE("no false shadow and no light leak in ten million rays", "[shadows][slow]") {
    for (const int frac_bits : {4, 6, 8, 12, 16})
        check_scheme(40000, unsigned(100 + frac_bits), {Method::surface, frac_bits});
}

TEST_CASE("other origins of secondary rays do shadow themselves and leak", "[shadows]") {
    for (const Method method : {Method::excluded, Method::pushed, Method::epsilon}) {
        ShadowCounts sum;
        for (const ShadowScene& scene : shadow_scenes())
            sum += shadow_counts(scene.make(16), 16, 5, 300, {method, 0});
        CAPTURE(int(method));
        REQUIRE(sum.false_shadows > 0);
        REQUIRE(sum.light_leaks > 0);
    }
}

TEST_CASE("shadow rays from every point of a small solid to every light are exact, on either side",
          "[shadows]") {
    const std::vector<Corners> mesh = shells();
    const std::size_t solid = prism().size();
    const int frac_bits = GENERATE(2, 3), one = 1 << frac_bits;
    int blocked = 0, free = 0, leaks_possible = 0;
    for (std::size_t own = 0; own < solid; ++own) {
        const PrimData prim = prim_of(mesh[own]);
        for (std::uint32_t u = 1; u + 1 < std::uint32_t(one); ++u)
            for (std::uint32_t v = 1; u + v < std::uint32_t(one); ++v) {
                const SurfacePoint p = surface_point(prim, {u, v}, frac_bits);
                for (int which = 0; which < 11 * 11 * 11; which += frac_bits == 3 ? 7 : 1) {
                    const Vec3i light{which % 11 - 5, which / 11 % 11 - 5, which / 121 - 5};
                    const int facing = side_of_point(prim, light);
                    if (facing == 0) continue;
                    const Vec3l d = shadow_direction(light, p);
                    Visibility visibility({{{p.at[0], p.at[1], p.at[2]}, one}, light, {}}, mesh[own], facing);
                    bool said = false;
                    for (const Corners& t : mesh) {
                        said = said || shadow_test(light, d, frac_bits, prim_of(t));
                        visibility.add(t);
                    }
                    CAPTURE(own, u, v, light[0], light[1], light[2]);
                    REQUIRE(visibility.answer() !=
                            (said ? Visibility::Answer::free : Visibility::Answer::blocked));
                    // Normals point outwards. A ray that leaves outwards and ends inside the solid, or the
                    // reverse, was stopped.
                    const Prism in = in_prism(light);
                    if (facing > 0 ? in.within : in.outside) {
                        REQUIRE(said);
                        ++leaks_possible;
                    }
                    (said ? blocked : free)++;
                }
            }
    }
    REQUIRE(blocked > 1000);
    REQUIRE(free > 1000);
    REQUIRE(leaks_possible > 1000);
}

TEST_CASE("the search around a way skips no triangle that it meets", "[shadows]") {
    for (const ShadowScene& scene : shadow_scenes()) {
        const oracle::Surface around(scene.make(12), 1);
        const auto& mesh = around.triangles();
        for (std::uint32_t i = 0; i < 200; ++i) {
            // From a corner of one triangle to a corner of another: both meet the path, and so do all that it
            // crosses.
            const std::uint32_t from = i * 7919u % std::uint32_t(mesh.size()),
                                to = i * 104729u % std::uint32_t(mesh.size());
            const Vec3i a = mesh[from].a, b = mesh[to].b;
            const auto place = [](const Vec3i& p) { return glm::dvec3(p[0], p[1], p[2]); };
            std::vector<bool> found(mesh.size());
            around.along(place(a), place(b), [&](std::uint32_t number) { return found[number] = true; });
            REQUIRE((found[from] && found[to]));
            const Vec3i d{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
            for (std::uint32_t t = 0; t < mesh.size(); ++t) {
                const auto hit = oracle::cross<oracle::Int128, std::int64_t>(a, d, mesh[t]);
                if (hit && hit->num <= hit->den) REQUIRE(found[t]);
            }
        }
    }
}
