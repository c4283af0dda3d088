// The side of a surface on which a reflected or refracted ray leaves: the sign of an exact product, which can
// be as small as one.
#include <cmath>

#include <catch2/catch.hpp>

#include "model/unit/shade/bounce/bounce.hpp"

using namespace rayclock;

TEST_CASE(
    "a ray leaves on its side if the normal's product with its direction is one or more, or minus one or "
    "less",
    "[pass][bounce]") {
    Config c;
    c.shading = c.refraction = 1;
    int ones = 0, noughts = 0;
    for (const int bits : {14, 16, 17, 20})
        for (std::int32_t x = -3; x <= 3; ++x)
            for (std::int32_t z = -9; z <= 9; ++z)
                for (const std::int64_t size : {1, 2, -1}) {
                    c.dir_bits = bits;
                    ShadeState state;
                    state.n = {0, x, size};
                    state.normal = {0, 0, 1 << unit_bits};
                    state.view = {-(1 << unit_bits), 0, z};
                    state.ratio = 1u << index_frac;
                    // With a cosine of 0 both are the reversed view.
                    const BounceOut reflected = reflect(c, state), refracted = refract(c, state);
                    REQUIRE(reflected.d == refracted.d);
                    const std::int64_t product = x * std::int64_t(reflected.d[1]) + size * reflected.d[2];
                    CAPTURE(bits, x, z, size, product);
                    REQUIRE(reflected.goes == (product > 0));
                    REQUIRE(refracted.goes == (product < 0));
                    ones += std::abs(product) == 1, noughts += product == 0;
                }
    CHECK(ones > 5);
    CHECK(noughts > 5);
}

TEST_CASE("with two levels a refracted ray is sent if a component is a quarter of a unit vector or more",
          "[pass][bounce]") {
    Config c;
    c.shading = c.refraction = 1;
    c.dir_bits = GENERATE(14, 18, 20);
    const std::int32_t quarter = 1 << (c.dir_bits - 4);
    int sent = 0, short_ones = 0;
    const double one = 1 << unit_bits, lean = 0.05;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int step = 1; step <= 250; ++step)
            for (const int side : {-1, 1}) {
                const double angle = step * 0.003;   // angle between view and triangle
                const std::size_t up = (axis + 1) % 3;
                ShadeState state;
                state.view[axis] = std::int32_t(std::lround(side * std::cos(angle) * one));
                state.view[up] = std::int32_t(std::lround(std::sin(angle) * one));
                state.normal[axis] = std::int32_t(std::lround(-side * std::cos(lean) * one));
                state.normal[up] = std::int32_t(std::lround(std::sin(lean) * one));
                state.n[up] = 1;
                state.ratio = std::uint32_t(std::lround(std::sqrt(0.5) * (1 << index_frac)));
                Placement place;   // the identity
                for (std::size_t i = 0; i < 3; ++i) place.a[4 * i] = 1 << c.map_frac();
                c.levels = 1;
                const BounceOut flat = refract(c, state);
                c.levels = 2;
                const BounceOut two = refract(c, state, place);
                REQUIRE(flat.d == two.d);
                const bool is_short = std::abs(two.d[0]) < quarter && std::abs(two.d[1]) < quarter &&
                                      std::abs(two.d[2]) < quarter;
                CAPTURE(axis, step, side, two.d);
                REQUIRE(two.goes == (flat.goes && !is_short));
                sent += two.goes, short_ones += flat.goes && is_short;
            }
    CHECK(sent > 50);
    CHECK(short_ones > 50);
}
