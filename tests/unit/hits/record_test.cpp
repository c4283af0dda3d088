// The width of the records that a chip writes into memory.
#include <algorithm>

#include <catch2/catch.hpp>

#include "model/core/payloads.hpp"
#include "tests/support/dut/format.hpp"

using namespace rayclock;

TEST_CASE("two records of hits fit into a line of memory in the chip with the widest fields", "[hits]") {
    struct Lattice {
        int coord, dir, origin;   // bits; wider ones are refused
    };
    int most = 0;
    for (const Lattice& l : {Lattice{20, 20, 10}, {20, 19, 10}, {18, 24, 12}})
        for (const bool planes : {false, true})
            for (const int levels : {1, 2}) {
                Config c = test::format("default");
                c.coord_bits = l.coord, c.dir_bits = l.dir, c.origin_bits = l.origin;
                c.t_frac_bits = 8, c.pixel_bits = max_pixel_bits, c.bary_bits = planes ? 19 : 24;
                c.contexts = 1024, c.pipelines = 8;
                c.shading = c.spheres = c.pixel_writes = true;
                c.planes = planes, c.levels = levels, c.source = RaySource::stream;
                REQUIRE_NOTHROW(check_config(c, "test"));
                CHECK(bits_of<HitRecord>(c) * hits_of_line(c) <= line_bits);
                most = std::max(most, bits_of<HitRecord>(c));
            }
    CHECK(most == 191);   // docs/guide/streams.md
}
