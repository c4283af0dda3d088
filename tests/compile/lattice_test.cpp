// The lattice: points are rounded to the nearest lattice point, within the scene's bounds.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "model/compile/lattice.hpp"
#include "model/layout/memory_image.hpp"
#include "tests/support/scenes/hard_meshes.hpp"

using namespace rayclock;

namespace {

/// Returns the distance from a point to its lattice point, in pitches, on the worst axis.
double off(const Lattice& lattice, const glm::dvec3& point) {
    const Vec3i k = lattice.snap(point);
    double worst = 0;
    for (int a = 0; a < 3; ++a)
        worst =
            std::max(worst, std::abs((lattice.centre[a] + lattice.pitch[a] * k[std::size_t(a)] - point[a]) /
                                     lattice.pitch[a]));
    return worst;
}

}   // namespace

TEST_CASE("every vertex lies within half a pitch of its lattice point") {
    const int bits = GENERATE(12, 16, 18, 20);
    const std::int32_t largest = (1 << (bits - 1)) - 1;
    for (Scene scene : {soup(500, 0.1, 7), sheet(10), needles(100, 3), extremes(), single(), coincident(3)}) {
        const glm::dvec3 shift =
            GENERATE(glm::dvec3{0}, glm::dvec3{1000, -20, 3}, glm::dvec3{-1e6, 1e6, 1e6});
        for (glm::dvec3& v : scene.vertices) v += shift;
        const glm::dvec3 eye = scene.vertices[0] + glm::dvec3{2, 3, -5};
        const Lattice lattice = fit_lattice(scene, eye, bits);
        INFO(scene.name << " with " << bits << " bits, shifted by " << shift.x);
        std::int32_t reached = 0;
        double worst = 0;
        for (const glm::dvec3& v : scene.vertices) {
            worst = std::max(worst, off(lattice, v));
            for (const std::int32_t x : lattice.snap(v)) reached = std::max(reached, std::abs(x));
        }
        for (const std::int32_t x : lattice.snap(eye)) reached = std::max(reached, std::abs(x));
        CHECK(worst <= 0.5 + 1e-6);
        CHECK(off(lattice, eye) <= 1e-6);
        CHECK(reached >= largest - 1);   // the range is used fully and is not exceeded
        CHECK(reached <= largest);
    }
}

TEST_CASE("an axis along which the scene is short has a finer pitch, down to half the coarsest") {
    Scene scene = named("box");
    add(scene, {0, 0, 0}, {8, 0, 0}, {8, 6, 1});
    const double largest = double((1 << 17) - 1);
    const Lattice lattice = fit_lattice(scene, {4, 1, 0.5}, 18);
    CHECK(lattice.pitch.x == 4 / largest);
    CHECK(lattice.pitch.y == 3 / largest);
    CHECK(lattice.pitch.z == 2 / largest);
    CHECK(lattice.coarsest() == lattice.pitch.x);
    // Directions are converted to lattice steps axis by axis, and the coarsest axis keeps its component.
    const glm::dvec3 d = lattice.direction({1, 1, 1});
    CHECK(d.x == 1);
    CHECK(d.y == Approx(4.0 / 3).epsilon(1e-15));
    CHECK(d.z == Approx(2).epsilon(1e-15));
}

TEST_CASE("halves snap away from zero") {
    Lattice lattice;
    lattice.coord_bits = 12;
    lattice.pitch = glm::dvec3{2};
    CHECK(lattice.snap({1, -1, 3}) == Vec3i{1, -1, 2});
    CHECK(lattice.snap({0.999, -0.999, 2.999}) == Vec3i{0, 0, 1});
    CHECK(lattice.snap({1e9, -1e9, 4094}) == Vec3i{2047, -2047, 2047});
}

TEST_CASE("degenerate extents have a lattice") {
    SECTION("all points equal") {
        Scene scene = named("point");
        add(scene, {5, 6, 7}, {5, 6, 7}, {5, 6, 7});
        const Lattice lattice = fit_lattice(scene, {5, 6, 7}, 18);
        CHECK(lattice.pitch == glm::dvec3{1});
        CHECK(lattice.snap({5, 6, 7}) == Vec3i{0, 0, 0});
    }
    SECTION("one extent only") {
        Scene scene = named("line");
        add(scene, {0, 6, 7}, {1, 6, 7}, {2, 6, 7});
        const Lattice lattice = fit_lattice(scene, {0, 6, 7}, 12);
        CHECK(lattice.snap({2, 6, 7}) == Vec3i{2047, 0, 0});
    }
    SECTION("the smallest and the largest doubles") {
        for (const double size : {5e-324, 1e-310, 1e308}) {
            Scene scene = named("far");
            add(scene, {-size, 0, 0}, {size, 0, 0}, {0, size, 0});
            const Lattice lattice = fit_lattice(scene, {0, 0, size}, 20);
            for (int a = 0; a < 3; ++a)
                CHECK((std::isfinite(lattice.pitch[a]) && lattice.pitch[a] > 0 &&
                       std::isfinite(lattice.centre[a])));
            for (const glm::dvec3& v : scene.vertices)
                for (const std::int32_t x : lattice.snap(v)) CHECK(std::abs(x) < 1 << 19);
        }
    }
    SECTION("vertices that no triangle uses do not count") {
        Scene scene = single();
        scene.vertices.push_back({1e6, 0, 0});
        CHECK(fit_lattice(scene, {0, 0, 1}, 18).coarsest() < 1e-4);
    }
}
