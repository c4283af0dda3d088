// Yosys's output for a hierarchy, converted to counts of a unit and of the cells below it.
#include <catch2/catch.hpp>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "sim/run/request/config_file.hpp"
#include "sim/silicon/area/synthesise_units.hpp"
#include "sim/silicon/area/variants.hpp"
#include "model/base/error.hpp"

using namespace rayclock;
using namespace rayclock::area;
using namespace rayclock::synth;

namespace {

/// The output of `stat -json` of Yosys 0.23, with its hierarchy that is not JSON.
constexpr const char* stat = R"({
   "creator": "Yosys",
   "modules": {
      "$paramod\\rc_sqrt\\Stages=s32'00000000000000000000000000001001": {
         "num_cells_by_type": {
            "LUT4": 5,
            "TRELLIS_FF": 7
         }
      },
      "$paramod$fd33b82d\\rc_divide": {
         "num_cells_by_type": {
            "CCU2C": 10,
            "LUT4": 100
         }
      },
      "$paramod$0123abcd\\rc_divide": {
         "num_cells_by_type": {
            "LUT4": 1
         }
      },
      "\\rc_recip": {
         "num_cells_by_type": {
            "$paramod$0123abcd\\rc_divide": 2,
            "$paramod$fd33b82d\\rc_divide": 1,
            "DP16KD": 1,
            "MULT18X18D": 3
         }
      },
      "\\rc_raygen": {
         "num_cells_by_type": {
            "$paramod\\rc_sqrt\\Stages=s32'00000000000000000000000000001001": 1,
            "L6MUX21": 50,
            "LUT4": 1000,
            "PFUMX": 60,
            "TRELLIS_DPR16X4": 4,
            "rc_recip": 3
         }
      }
   },
       rc_recip                      3
         $paramod$fd33b82d\rc_divide      1
      "design": {
      }
}
)";

}   // namespace

TEST_CASE("a unit's count has what is beneath it, and each kind of cell once, whatever its parameters") {
    const Part unit = parts_of_stat(stat, "raygen");
    CHECK(unit.name == "raygen");
    CHECK(unit.count == Count{1000 + 5 + 3 * 102, 3 * 10, 4, 7, 3 * 3, 3});
    CHECK(unit.count.luts() == 1311 + 2 * 30 + 6 * 4);
    REQUIRE(unit.parts.size() == 2);
    CHECK(unit.parts[0].name == "recip");
    CHECK(unit.parts[0].times == 3);
    CHECK(unit.parts[0].count == Count{3 * 102, 3 * 10, 0, 0, 9, 3});
    REQUIRE(unit.parts[0].parts.size() == 1);
    CHECK(unit.parts[0].parts[0].name == "divide");
    CHECK(unit.parts[0].parts[0].times == 9);
    CHECK(unit.parts[0].parts[0].count == Count{3 * 102, 3 * 10, 0, 0, 0, 0});
    CHECK(unit.parts[1].name == "sqrt");
    CHECK(unit.parts[1].count == Count{5, 0, 0, 7, 0, 0});
    CHECK_THROWS_AS(parts_of_stat(stat, "shade"), std::runtime_error);
    // The cache's format.
    const auto json = part_json(unit);
    CHECK(part_json(part_of(json)) == json);
    CHECK(part_of(json).count == unit.count);
}

TEST_CASE("any configuration that can shade has a variant for each unit") {
    for (const std::string& name : config_names()) {
        INFO(name);
        const std::vector<Variant> all = variants_of(named_config(name));
        REQUIRE(all.size() == 11);
        CHECK(!all[0].config.shading);
        CHECK(all[1].config.is_stream());
        CHECK(!all[1].config.writes_hits());
        CHECK(all[2].config.writes_hits());
        CHECK(all[2].base == 1);
        CHECK(all[3].config.has_shade());
        CHECK(all[1].base + all[3].base == 0);
        const auto further = [](const Config& c) {
            return c.spheres + c.planes + c.smooth + c.refraction + c.supersampling + c.textures;
        };
        for (std::size_t v = 0; v < 4; ++v) CHECK(further(all[v].config) == 0);
        for (std::size_t v = 4; v < 10; ++v) CHECK(further(all[v].config) == 1);
        CHECK(further(all[10].config) == 6);
        for (std::size_t v = 4; v < 11; ++v) CHECK(all[v].base == 3);
        for (const Variant& v : all) CHECK(v.config.coord_bits == named_config(name).coord_bits);
    }
    Config sheared = named_config("default");
    set_parameter(sheared, "primitive_test", "sheared", "test");
    CHECK_THROWS_AS(variants_of(sheared), UserError);
}

TEST_CASE("a chip has the units of its source of rays") {
    const auto units_of = [](const Config& config) {
        std::set<std::string> names;
        for (const UnitRow& row : unit_rows())
            if (row.is_there(config)) names.insert(row.name);
        return names;
    };
    const Config drawing = shading_alone(named_config("default"));
    const Config streaming = streaming_alone(named_config("default"));
    const std::set<std::string> drawn = units_of(drawing), streamed = units_of(streaming);
    std::vector<std::string> lost, gained;
    std::set_difference(drawn.begin(), drawn.end(), streamed.begin(), streamed.end(),
                        std::back_inserter(lost));
    std::set_difference(streamed.begin(), streamed.end(), drawn.begin(), drawn.end(),
                        std::back_inserter(gained));
    CHECK(lost == std::vector<std::string>{"raygen", "shade", "surf_cache"});
    CHECK(gained == std::vector<std::string>{"raygen_stream", "stream"});
}
