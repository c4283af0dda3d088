// The names by which tests select chips.
#include <catch2/catch.hpp>

#include "tests/support/cases/pass_cases.hpp"
#include "tests/support/cases/tex_cases.hpp"
#include "tests/support/dut/format.hpp"

using namespace rayclock;
using namespace rayclock::test;

TEST_CASE("every word of a format's name changes the chip", "[format]") {
    CHECK(format("wide").coord_bits == 20);
    const Config c = format("every2:lanes1:rays8:fast:shading:narrow");
    CHECK(c.tri_interval == 2);
    CHECK(c.box_lanes == 1);
    CHECK(c.raygen_interval == 8);
    CHECK(c.timing == Timing::fast);
    CHECK(c.shading == 1);
    CHECK(c.spheres == 1);
    CHECK(c.coord_bits == 12);
    CHECK(format("sheared:default").primitive_test == PrimitiveTest::sheared);
    CHECK(format("samples:default").supersampling == 1);
    CHECK(shaded_format("textured:every4:fast:plain").shade_interval == 4);
}

TEST_CASE("a misspelt name of a format throws", "[format]") {
    const char* name =
        GENERATE("", "defualt", "default:", "shadng:default", "fast1:default", "every:default",
                 "every3:default", "every22:default", "lanes3:default", ":default", "fast:narow");
    CAPTURE(name);
    CHECK_THROWS_AS(format(name), std::invalid_argument);
    CHECK_THROWS_WITH(format("narow"), Catch::Contains("'narow'") && Catch::Contains(" narrow "));
}

TEST_CASE("a misspelt name of a chip that shades throws", "[format]") {
    const char* name = GENERATE("", "al", "all:", "texturd:all", "fast1:all", "every:all", "every3:all",
                                "level:all", ":all", "fast:narow", "default");
    CAPTURE(name);
    CHECK_THROWS_AS(shaded_format(name), std::invalid_argument);
}

TEST_CASE("a misspelt name of a chip with textures throws", "[format]") {
    const char* name = GENERATE("", "rgb88", "rgb888:", "fast:rgb888", "level", "all");
    CAPTURE(name);
    CHECK_THROWS_AS(tex_config(name), std::invalid_argument);
}
