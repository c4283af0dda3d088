// Axes and grids; expected values are computed by hand.
#include <algorithm>
#include <set>

#include "model/base/error.hpp"
#include "model/core/parameters.hpp"
#include "sim/explore/sweep/shard.hpp"
#include "tests/sweep/small_sweeps.hpp"

using namespace rayclock;
using namespace rayclock::test;
using Strings = std::vector<std::string>;

TEST_CASE("an axis is a list or a range") {
    CHECK(sweep::parse_axis("dram=ddr3,sdr").key == "dram");
    CHECK(sweep::parse_axis("dram=ddr3,sdr").values == Strings{"ddr3", "sdr"});
    CHECK(sweep::parse_axis("coord_bits=12:20:2").values == Strings{"12", "14", "16", "18", "20"});
    CHECK(sweep::parse_axis("coord_bits=12:17:2").values == Strings{"12", "14", "16"});
    CHECK(sweep::parse_axis("tile_bits=3:5").values == Strings{"3", "4", "5"});
    CHECK(sweep::parse_axis("box_bits=6:6").values == Strings{"6"});
    for (const char* bad : {"coord_bits", "=1", "coord_bits=", "a=1:2:3:4", "a=1:x", "a=3:1", "a=1:3:0"}) {
        INFO(bad);
        CHECK_THROWS_AS(sweep::parse_axis(bad), UserError);
    }
}

TEST_CASE("linked parameters change together") {
    const std::vector<sweep::Point> points =
        points_of({"node_sets/prim_sets=16/64,32/32,64/16", "contexts/clock=32/66,64/33"});
    REQUIRE(points.size() == 6);
    CHECK(points[3].values == Strings{"32/32", "64/33"});
    CHECK(points[4].config.node_sets == 64);
    CHECK(points[4].config.prim_sets == 16);
    CHECK(points[4].config.contexts == 32);
    CHECK(points[5].khz == 33000);
    for (const sweep::Point& point : points)
        CHECK(sweep::pipeline_cache_bytes(point.config) ==
              64u * 4 * unsigned(point.config.node_sets + point.config.prim_sets));
    for (const char* bad : {"a/b=1", "a/b=1/2/3", "a/b=1:2", "a=1/2"}) {
        INFO(bad);
        CHECK_THROWS_AS(sweep::parse_axis(bad), UserError);
    }
    CHECK_THROWS_AS(points_of({"node_sets/contexts=16/64", "contexts=32"}), UserError);
    CHECK_THROWS_AS(points_of({"node_sets/node_sets=16/64"}), UserError);
}

TEST_CASE("a grid has every combination, the last axis fastest") {
    const std::vector<sweep::Point> points = points_of({"coord_bits=12,14", "clock=33,66,200"});
    REQUIRE(points.size() == 6);
    CHECK(points[1].values == Strings{"12", "66"});
    CHECK(points[1].config.coord_bits == 12);
    CHECK(points[1].khz == 66000);
    CHECK(points[5].values == Strings{"14", "200"});
    CHECK(points[5].config.coord_bits == 14);
    CHECK(points[5].khz == 200000);
    CHECK_THROWS_AS(points_of({"coord_bits=12,14", "coord_bits=16"}), UserError);
}

TEST_CASE("values that do not go together are a refused point, a value that goes with none is a mistake") {
    const std::vector<sweep::Point> points = points_of({"coord_bits=18,20", "dir_bits=22,24"});
    REQUIRE(points.size() == 4);
    for (std::size_t i = 0; i < 3; ++i) CHECK(points[i].refused.empty());
    CHECK(points[3].refused.find("2 * coord_bits + dir_bits") != std::string::npos);
    CHECK_THROWS_AS(points_of({"coord_bits=20", "dir_bits=24"}), UserError);
    CHECK_THROWS_AS(points_of({"coord_bits=18", "contexts=3,4"}), UserError);
}

TEST_CASE("a chip that shades gets origins as wide as its other widths allow, unless they are an axis") {
    Config base = named_config("ulx3s-shaded");
    for (const sweep::Point& point : points_of({"coord_bits=14:20:2", "bary_bits=8,16"}, base)) {
        INFO(point.values[0] << " and " << point.values[1] << ": " << point.refused);
        const Config& c = point.config;
        CHECK(point.refused.empty());
        CHECK(c.origin_bits == std::min({base.origin_bits, 30 - c.coord_bits, c.bary_bits}));
    }
    for (const sweep::Point& point : points_of({"origin_bits=8,9"}, base))
        CHECK(std::to_string(point.config.origin_bits) == point.values[0]);
    CHECK_THROWS_AS(points_of({"shading=0,1"}), UserError);
}

TEST_CASE("timing does not make another trace, every width does") {
    const Config base = named_config("default");
    for (const Parameter& p : parameters()) {
        INFO(p.key);
        Config other = base;
        p.set(other, p.get(base) == p.lo ? p.hi : p.lo);
        const std::string key = p.key;
        const bool is_format = key.ends_with("_bits")
                                   ? key != "tile_bits"
                                   : key == "node_width" || key == "leaf_size" || key == "stack_depth" ||
                                         key == "primitive_test" || key == "structure" ||
                                         key == "straddlers" || key == "splits" || key == "references" ||
                                         key == "levels" || key == "mesh_structure" || key == "shading" ||
                                         key == "spheres" || key == "planes" || key == "smooth" ||
                                         key == "refraction" || key == "panes" || key == "horizon" ||
                                         key == "supersampling" || key == "source" || key == "textures" ||
                                         key == "texels" || key == "lights" || key == "bounces";   // may be
                                                                                                   // too few
        CHECK((sweep::trace_format(other) != sweep::trace_format(base)) == is_format);
    }
}

TEST_CASE("parts of a sweep share no point, miss none, and cut few traces") {
    // Every fourth point shares a trace.
    const std::vector<sweep::Point> points = points_of({"clock=33,66,90,120,200", "coord_bits=12,14,16,18"});
    for (const int of : {1, 3, 4, 7, 20}) {
        INFO(of << " parts");
        std::vector<int> seen(points.size());
        std::size_t traces = 0;
        for (int part = 1; part <= of; ++part) {
            std::set<std::string> formats;
            const std::vector<std::size_t> mine = sweep::points_of({part, of}, points);
            CHECK(std::is_sorted(mine.begin(), mine.end()));
            CHECK(mine.size() >= points.size() / std::size_t(of));
            CHECK(mine.size() <= points.size() / std::size_t(of) + 1);
            for (const std::size_t i : mine) {
                ++seen[i];
                formats.insert(sweep::trace_format(points[i].config));
            }
            traces += formats.size();
        }
        CHECK(seen == std::vector<int>(points.size(), 1));
        CHECK(traces <= 4 + std::size_t(of) - 1);   // each cut divides at most one trace
    }
    CHECK_THROWS_AS(sweep::points_of({1, 21}, points), UserError);
}
