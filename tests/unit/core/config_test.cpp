// config: legal values, the messages of refused ones, and the guarantee that every legal configuration fits.
#include <catch2/catch.hpp>

#include "model/engine/engines.hpp"
#include "model/base/error.hpp"
#include "model/engine/check.hpp"
#include "model/core/layout.hpp"
#include "model/core/payloads.hpp"
#include "model/core/parameters.hpp"
#include "tests/support/cases/draw.hpp"

using namespace rayclock;
using Catch::Contains;

TEST_CASE("the named configurations are legal and known by their names", "[config]") {
    for (const std::string& name : config_names()) {
        const Config config = named_config(name);
        REQUIRE(config.name == name);
        REQUIRE_NOTHROW(check_config(config, name));
    }
    REQUIRE_THROWS_WITH(named_config("smal"), Contains("'smal'") && Contains("small"));
}

TEST_CASE("every parameter can be set, and is held to its range", "[config]") {
    for (const Parameter& p : parameters()) {
        CAPTURE(p.key);
        Config config;
        for (const int value : {p.lo, p.hi}) {
            set_parameter(config, p.key, p.names ? (*p.names)[std::size_t(value)] : std::to_string(value),
                          "here");
            REQUIRE(p.get(config) == value);
            REQUIRE(value_text(config, p) ==
                    (p.names ? (*p.names)[std::size_t(value)] : std::to_string(value)));
        }
        for (const int bad : {p.lo - 1, p.hi + 1}) {
            const bool line = std::string(p.key).ends_with("_line") && bad < p.lo;
            const auto refused = Contains("here: " + std::string(p.key) + " must " +
                                          (line ? "be at least 64 bytes" : "lie in"));
            Config wrong;
            if (p.type == Parameter::Type::flag) {
                REQUIRE_THROWS_WITH(set_parameter(wrong, p.key, std::to_string(bad), "here"), refused);
                continue;
            }
            p.set(wrong, bad);
            REQUIRE_THROWS_WITH(check_config(wrong, "here"), refused);
        }
        if (!p.power_of_two()) continue;
        Config odd;
        p.set(odd, p.lo < 2 ? 3 : p.lo + 1);
        REQUIRE_THROWS_WITH(check_config(odd, "here"), Contains("power of two"));
    }
}

TEST_CASE("a parameter that does not exist or is not a number is refused", "[config]") {
    Config config;
    REQUIRE_THROWS_WITH(set_parameter(config, "coord_bit", "12", "f"),
                        Contains("f: ") && Contains("coord_bits"));
    for (const char* text : {"", "x", "12x", "1.5", " 12", "99999999999"})
        REQUIRE_THROWS_WITH(set_parameter(config, "coord_bits", text, "f"), Contains("whole number"));
    REQUIRE(config.coord_bits == Config{}.coord_bits);
}

TEST_CASE("a named value that does not exist is refused with the nearest", "[config]") {
    Config config;
    for (const std::string& name : names_of<DramName>()) {
        set_parameter(config, "dram", name, "f");
        REQUIRE(name_of(config.dram) == name);
    }
    REQUIRE_THROWS_WITH(set_parameter(config, "dram", "ddr5", "f"),
                        Contains("f: ") && Contains("'ddr5'") && Contains("ddr3"));
    REQUIRE_THROWS_WITH(set_parameter(config, "dram", "1", "f"), Contains("'1'"));
}

TEST_CASE("whatever is legal fits its integers and memory lines", "[config]") {
    test::Draw draw{1};
    int legal = 0;
    for (int i = 0; i < 50000; ++i) {
        Config c;
        for (const Parameter& p : parameters()) {
            if (p.power_of_two()) {
                int value = p.lo;
                while (value < p.hi && draw.coin()) value *= 2;
                p.set(c, value);
            } else {
                p.set(c, draw.below(4) == 0 ? (draw.coin() ? p.lo : p.hi) : draw.between(p.lo, p.hi));
            }
        }
        if (!c.planes || !c.refraction) c.panes = 0;
        if (!c.planes || c.origin_bits < far_drop) c.horizon = 0;
        if (c.is_board()) {
            c.source = RaySource::camera;
            c.pipelines = c.dram_channels = 1;
            c.scan_out = c.pixel_writes = true;
        }
        if (c.is_stream()) c.scan_out = false;
        try {
            check_config(c, "");
        } catch (const UserError&) {
            continue;
        }
        ++legal;
        REQUIRE(c.t_bits() <= 31);
        REQUIRE(c.edge_bits() <= (c.shading ? 96 : 64));   // secondary rays need 128-bit integers
        REQUIRE(c.num_bits() <= (c.shading ? 96 : 64));
        REQUIRE(c.guard_dir_bits() <= 64);
        REQUIRE(c.dir_bits < 1 << exp_bits);
        REQUIRE(bits_of<Node>(c) <= line_bits);
        REQUIRE(bits_of<PrimData>(c) <= half_line_bits);
        REQUIRE((1 << c.ray_bits()) >= c.contexts);
        REQUIRE((1 << c.group_bits()) > c.node_width);
        REQUIRE((1 << c.stack_bits()) > c.stack_depth);
        REQUIRE((1 << c.node_miss_bits()) >= c.node_mshrs * (c.node_line / line_bytes));
        REQUIRE((1 << c.prim_miss_bits()) >= c.prim_mshrs * (c.prim_line / line_bytes));
        REQUIRE((1 << c.l2_miss_bits()) >= c.l2_mshrs * (c.l2_line / line_bytes));
        REQUIRE((1 << c.client_bits()) >= 2 * c.pipelines);
        REQUIRE(c.client_id_bits() >= c.client_bits() + std::max(c.node_miss_bits(), c.prim_miss_bits()));
        if (c.has_textures()) {
            REQUIRE((1 << c.tex_miss_bits()) >= c.tex_mshrs * (c.tex_line / line_bytes));
            REQUIRE(c.client_id_bits() >= c.client_bits() + c.tex_miss_bits());
        }
        REQUIRE(c.client_id_bits() <= 16);
        REQUIRE((1 << (c.tile_coord_bits() + c.tile_bits)) == 1 << c.pixel_bits);
        REQUIRE(c.addr_bits >= c.least_addr_bits());
        REQUIRE(c.tile_coord_bits() >= 1);
        REQUIRE(2 * c.node_width * 3 + 6 < 1 << offset_bits);   // all leaves are full: 6 half lines each
        REQUIRE(c.leaf_size + 1 < 1 << count_bits);
    }
    REQUIRE(legal > 800);   // of 50,000
}

TEST_CASE("widths that do not fit together are refused with the rule", "[config]") {
    Config tags;
    tags.prim_sets = 1024;
    tags.prim_line = 256;
    tags.addr_bits = 12;
    REQUIRE_THROWS_WITH(check_config(tags, "c"), Contains("addr_bits must be at least 13"));
    tags.addr_bits = 13;
    REQUIRE_NOTHROW(check_config(tags, "c"));
    tags.l2_sets = 16384;
    REQUIRE_THROWS_WITH(check_config(tags, "c"), Contains("addr_bits must be at least 15"));
    Config edge;
    edge.coord_bits = 20;
    edge.dir_bits = 23;
    REQUIRE_THROWS_WITH(check_config(edge, "c"), Contains("2 * coord_bits + dir_bits must not exceed 62"));
    Config box;
    box.coord_bits = 20;
    box.dir_bits = 22;
    box.box_bits = 4;
    box.t_frac_bits = 8;
    REQUIRE_THROWS_WITH(check_config(box, "c"), Contains("more than 63"));
}

TEST_CASE("index_bits counts the bits of 0 to n - 1", "[config]") {
    const std::pair<int, int> cases[] = {{1, 1}, {2, 1},  {3, 2},  {4, 2},
                                         {5, 3}, {64, 6}, {65, 7}, {1024, 10}};
    for (const auto& [n, bits] : cases) REQUIRE(index_bits(n) == bits);
}
