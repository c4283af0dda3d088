// On which side of a surface a reflected ray leaves: the sign of an exact product, which may be as small as one.
#include <catch2/catch.hpp>

#include "model/shade/bounce.hpp"

using namespace rayclock;

TEST_CASE("a reflected ray leaves if the normal's product with its direction is one or more", "[pass][bounce]") {
    Config c;
    c.shading = 1;
    int ones = 0;
    for (const int bits : {14, 16, 17, 20})
        for (std::int32_t x = -3; x <= 3; ++x)
            for (std::int32_t z = -9; z <= 9; ++z)
                for (const std::int64_t size : {1, 2, -1}) {
                    c.dir_bits = bits;
                    ShadeState state;
                    state.n = {0, x, size};
                    state.normal = {0, 0, 1 << unit_bits};
                    state.view = {-(1 << unit_bits), 0, z};
                    const BounceOut out = reflect(c, state);   // cosine 0: the view turned round
                    const std::int64_t product = x * std::int64_t(out.d[1]) + size * out.d[2];
                    CAPTURE(bits, x, z, size, product);
                    REQUIRE(out.goes == (product > 0));
                    ones += product == 1;
                }
    CHECK(ones > 5);
}
