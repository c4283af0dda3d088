// The bound for the point where a ray grazes a sphere, if the ray is moved slightly.
#include <catch2/catch.hpp>

#include <cmath>
#include <random>

#include "sim/judge/cause/tie.hpp"

using namespace rayclock;

namespace rayclock::test::graze_test {

namespace {

using Int128 = long double;

/// Returns the near root of a ray in the x-y plane that passes the centre at distance `aside`.
Int128 near_root(Int128 to_middle, Int128 aside, Int128 radius) {
    return to_middle - std::sqrt(radius * radius - aside * aside);
}

}   // namespace

TEST_CASE("a moved ray meets a sphere within the bound, however closely it grazes") {
    std::mt19937_64 random{1};
    std::uniform_real_distribution<double> unit(0, 1);
    int grazing = 0;
    double closest = 1e9;
    for (int i = 0; i < 100'000; ++i) {
        const double radius = 0.01 + unit(random), to_middle = 0.5 + unit(random),
                     off = std::ldexp(1 + unit(random), -36);
        const double gap = i % 2 ? std::ldexp(radius, -1 - int(40 * unit(random))) : radius * unit(random);
        const Int128 aside = Int128(radius) - Int128(gap);   // of the ray before the move
        const Int128 moved = aside + (i % 4 < 2 ? off : -off);
        if (moved >= Int128(radius) || aside < 0) continue;
        const double bound =
            graze_error({to_middle, double(aside), 0}, {1, 0, 0}, radius, off + std::ldexp(radius, -50));
        const double moves = double(std::abs(near_root(Int128(to_middle), moved, Int128(radius)) -
                                             near_root(Int128(to_middle), aside, Int128(radius))));
        INFO("radius " << radius << ", gap " << gap << ", off " << off << ", moves " << moves);
        REQUIRE(moves <= bound);
        if (gap > radius * 0x1p-20) continue;
        ++grazing;
        closest = std::min(closest, bound / moves);
    }
    CHECK(grazing > 1000);
    CHECK(closest < 4);   // in the closest case the bound is less than four times the move
}

TEST_CASE("a ray of the spheres that the judge once refused lies within the bound") {
    // The reflection of spheres at 640x480 with 16 samples, pixel (393, 404), in lattice steps: the tracer's
    // point lies 0.00411 steps before the exact one, since the ray was moved by 1.6e-6 steps.
    const double step = 8.9387871853546911e-06;
    const glm::dvec3 direction = glm::normalize(glm::dvec3(5000, 104372, -240420)),
                     origin = glm::dvec3(50524192, -137465856, -31691360) / 4096.0,
                     to_centre = glm::dvec3(13984, -5593, -19577) - origin;
    const double radius = std::sqrt(439992576.0);
    const double bound = graze_error(step * to_centre, direction, step * radius, off_surface_size) / step;
    CHECK(bound > 0.00411);
    CHECK(bound < 0.02);
}

}   // namespace rayclock::test::graze_test
