// Compares the reference's spheres and planes with long double arithmetic and with rules that need no tracer.
// Embree is a second opinion.
#include <cmath>

#include <catch2/catch.hpp>

#include "sim/judge/reference/geometry.hpp"
#include "sim/judge/reference/reference.hpp"
#include "model/scene/builtin.hpp"
#include "tests/support/scenes/embree_scene.hpp"
#include "tests/reference/meshes.hpp"

using namespace rayclock;

namespace {

using Real = long double;

struct Answer {
    std::uint32_t primitive = no_primitive;
    Real depth = INFINITY;
    bool is_close = false;   ///< two hits, or a hit and a miss, differ by less than rounding
};

/// Tests every sphere and plane with a mantissa of 64 bits.
Answer brute_force(const Scene& scene, const glm::dvec3& o, const glm::dvec3& direction) {
    const glm::dvec3 d = glm::normalize(direction);
    Answer best;
    const auto keep = [&](std::uint32_t primitive, Real depth) {
        if (!(depth > 0)) return;
        best.is_close = best.is_close || std::abs(depth - best.depth) < 1e-9L;
        if (depth < best.depth) best.depth = depth, best.primitive = primitive;
    };
    for (std::uint32_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere& s = scene.spheres[i];
        const Real x = Real(o.x) - s.centre.x, y = Real(o.y) - s.centre.y, z = Real(o.z) - s.centre.z;
        const Real a = Real(d.x) * d.x + Real(d.y) * d.y + Real(d.z) * d.z;
        const Real b = (x * d.x + y * d.y + z * d.z) / a,
                   c = (x * x + y * y + z * z - Real(s.radius) * s.radius) / a;
        const Real inside = b * b - c;
        best.is_close = best.is_close || std::abs(inside) < 1e-9L;
        if (inside < 0) continue;
        const Real enter = -b - std::sqrt(inside), leave = -b + std::sqrt(inside);
        if (enter > 0)
            keep(i, enter);
        else if (scene.materials[s.material].transmit > 0)
            keep(i, leave);
    }
    for (std::uint32_t i = 0; i < scene.planes.size(); ++i) {
        const Plane& p = scene.planes[i];
        const glm::dvec3 n = glm::cross(p.u, p.v), q = p.point - o;
        const Real slope = Real(n.x) * d.x + Real(n.y) * d.y + Real(n.z) * d.z;
        best.is_close = best.is_close || std::abs(slope) < 1e-6L;
        if (slope != 0)
            keep(static_cast<std::uint32_t>(scene.spheres.size()) + i,
                 (Real(n.x) * q.x + Real(n.y) * q.y + Real(n.z) * q.z) / slope);
    }
    return best;
}

/// Returns balls of all sizes, some of glass, and two planes.
Scene balls_and_planes(MeshRng& rng, int count) {
    Scene scene = empty_scene();
    scene.materials.push_back({.name = "glass", .transmit = 0.5, .index = 1.5});
    for (int i = 0; i < count; ++i)
        scene.spheres.push_back(
            {random_point(rng), std::pow(10, uniform(rng, -4, -0.7)), static_cast<std::uint32_t>(i % 2)});
    scene.planes = {{{0, -0.8, 0}, {1, 0, 0}, {0, 0, -1}, 0},
                    {{0.3, 0.1, -0.9}, {1, 0.2, 0}, {-0.1, 1, 0.3}, 0}};
    return scene;
}

}   // namespace

TEST_CASE("spheres and planes are found like by trying each", "[reference][round]") {
    MeshRng rng(11);
    const Scene scene = balls_and_planes(rng, 300);
    const Reference reference(scene);
    int spheres = 0, planes = 0, inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 from = random_point(rng, 1.5),
                         towards = i % 3 == 0 ? random_direction(rng) : random_point(rng) - from;
        const Answer wanted = brute_force(scene, from, towards);
        if (wanted.is_close) continue;
        const Hit hit = reference.trace(from, towards);
        CAPTURE(i);
        REQUIRE(hit.primitive == wanted.primitive);
        if (hit.primitive == no_primitive) continue;
        REQUIRE(hit.depth == Approx(static_cast<double>(wanted.depth)).epsilon(1e-6));
        const glm::dvec3 p = from + static_cast<double>(hit.depth) * glm::normalize(towards);
        if (hit.primitive >= 300) {
            const Plane& plane = scene.planes[hit.primitive - 300];
            REQUIRE(glm::length(plane.point + double(hit.u) * plane.u + double(hit.v) * plane.v - p) <
                    1e-5 * (1 + hit.depth));
            ++planes;
        } else {
            ++spheres;
            inside +=
                glm::length(scene.spheres[hit.primitive].centre - from) < scene.spheres[hit.primitive].radius;
        }
    }
    CHECK(spheres > 3000);
    CHECK(planes > 1000);
    CHECK(inside > 10);
}

TEST_CASE("triangles, spheres and planes count through", "[reference][round]") {
    Scene scene = empty_scene();
    add_triangle(scene, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
    scene.spheres = {{{5, 0, 0}, 1, 0}, {{5, 0, -0.5}, 0.5, 0}};
    scene.planes = {{{0, 0, -9}, {1, 0, 0}, {0, 1, 0}, 0}};
    const Reference reference(scene);
    CHECK(reference.trace({0, 0, 4}, {0, 0, -1}).primitive == 0);
    CHECK(reference.trace({5, 0, 4}, {0, 0, -1}).primitive == 1);
    // Both begin at z = -1: the lower number wins.
    CHECK(reference.trace({5, 0, -4}, {0, 0, 1}).primitive == 1);
    CHECK(reference.trace({9, 0, 4}, {0, 0, -1}).primitive == 3);
    CHECK(reference.trace({9, 0, 4}, {0, 0, 1}).primitive == no_primitive);
    CHECK(reference.trace({9, 0, 4}, {1, 0, 0}).primitive == no_primitive);
}

TEST_CASE("an opaque sphere is not seen from inside, a glass one is", "[reference][round]") {
    Scene scene = empty_scene();
    scene.spheres = {{{0, 0, 0}, 1, 0}};
    CHECK(Reference(scene).trace({0, 0, 0.5}, {0, 0, 1}).primitive == no_primitive);
    scene.materials[0].transmit = 0.1;
    CHECK(Reference(scene).trace({0, 0, 0.5}, {0, 0, 1}).depth == 0.5f);
    CHECK(Reference(scene).trace({0, 0, 0.5}, {0, 0, -1}).depth == 1.5f);
}

TEST_CASE("tiny, huge and far spheres keep their outlines", "[reference][round]") {
    for (const double radius : {1e-30, 1e-3, 1.0, 1e30})
        for (const double away : {0.0, 1e4}) {
            CAPTURE(radius, away);
            Scene scene = empty_scene();
            const glm::dvec3 centre(away * radius, 0, 0);
            scene.spheres = {{centre, radius, 0}};
            const Reference reference(scene);
            const glm::dvec3 eye = centre + radius * glm::dvec3(0, 0, 10);
            CHECK(reference.trace(eye, {0, 0, -1}).depth == Approx(9 * radius));
            for (const double y : {0.999, 1.001}) {
                const Hit hit = reference.trace(centre + radius * glm::dvec3(0, y, 10), {0, 0, -1});
                CHECK((hit.primitive == 0) == (y < 1));
            }
        }
}

TEST_CASE("a ray does not meet the surface that it left, except the far side of a sphere",
          "[reference][round]") {
    MeshRng rng(5);
    Scene scene = empty_scene();
    scene.materials[0].transmit = 1;
    scene.spheres = {{{0.3, -0.2, 0.1}, 0.7, 0}};
    const RefGeometry geometry(scene);
    const double r = 0.7 * geometry.space().scale;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 normal = random_direction(rng),
                         on = geometry.space()(scene.spheres[0].centre) + r * normal;
        glm::dvec3 d = random_direction(rng);
        if (i % 4 == 0) d = glm::normalize(glm::cross(normal, d) + 1e-7 * d);   // nearly along the surface
        const bool is_inward = glm::dot(d, normal) < 0;
        for (const double side : {-0x1p-36, 0.0, 0x1p-36})
            CHECK(geometry.closest({on + side * normal, d, 0, false}).primitive == no_primitive);
        if (!is_inward) continue;
        // A start slightly inside has a far side, for any angle of the ray. Its chord is longer by at most
        // sqrt(2^-35 r).
        const RefClosest hit = geometry.closest({on - 0x1p-36 * normal, d, 0, true});
        REQUIRE(hit.primitive == 0);
        REQUIRE(hit.depth == Approx(-2 * r * glm::dot(d, normal)).margin(5e-6));
    }
}

TEST_CASE("only what lies before the light blocks it", "[reference][round]") {
    Scene scene = empty_scene();
    scene.spheres = {{{0, 0, 0}, 1, 0}};
    scene.planes = {{{0, 0, 5}, {1, 0, 0}, {0, 1, 0}, 0}};
    add_triangle(scene, {-1, -1, -3}, {1, -1, -3}, {0, 1, -3});
    const RefGeometry geometry(scene);
    const double scale = geometry.space().scale;
    const RefPath path{geometry.space()({0, 0, -5}), {0, 0, 1}};
    CHECK_FALSE(geometry.is_blocked(path, 1.99 * scale));
    CHECK(geometry.is_blocked(path, 2.01 * scale));
    RefPath left = path;
    left.left = 0;
    CHECK_FALSE(geometry.is_blocked(left, 3.99 * scale));
    CHECK(geometry.is_blocked(left, 4.01 * scale));
    left = {geometry.space()({0, 0, 1}), {0, 0, 1}, 1, false};
    CHECK_FALSE(geometry.is_blocked(left, 3.99 * scale));
    CHECK(geometry.is_blocked(left, 4.01 * scale));
}

TEST_CASE("Embree finds the same spheres, except for its rounding", "[reference][round][embree]") {
    Scene scene = make_builtin(GENERATE("balls:3", "rings:2", "tree:5", "spheres"), Primitives::native);
    scene.triangles.clear();
    scene.planes.clear();
    const EmbreeSpheres embree(scene);
    const FrameSize size{256, 192};
    const HitFrame frame = Reference(scene).frame(*scene.camera, size);
    const PixelRays rays = pixel_rays(*scene.camera, size);
    int hits = 0, others = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Hit ours = frame.hits[y * size.width + x],
                      theirs = embree.trace(rays.eye, glm::normalize(rays.direction(x, y)));
            hits += ours.primitive != no_primitive;
            others += ours.primitive != theirs.primitive;
            if (ours.primitive != theirs.primitive || ours.primitive == no_primitive) continue;
            // The depth at a sphere's outline is known only to the root of its position's rounding error.
            const double grazing = std::sqrt(scene.spheres[ours.primitive].radius * 1e-6 * ours.depth);
            REQUIRE(std::abs(ours.depth - theirs.depth) < 1e-5 * ours.depth + grazing);
        }
    CHECK(hits > 400);
    CHECK(others <= hits / 500);
    WARN(scene.name << ": " << hits << " pixels hit, " << others << " with another sphere");
}
