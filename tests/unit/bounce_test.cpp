// On which side of a surface a reflected or refracted ray leaves: the sign of an exact product, which may be
// as small as one.
#include <catch2/catch.hpp>

#include "model/shade/bounce.hpp"

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
                    // With a cosine of 0 both are the view turned round.
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
