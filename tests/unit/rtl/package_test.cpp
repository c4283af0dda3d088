// The generated SystemVerilog package is current, and complete for every configuration.
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include "model/core/parameters.hpp"
#include "model/machine/links.hpp"
#include "sim/run/gen/chip_page.hpp"
#include "sim/run/gen/rc_pkg.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/run/rtl/sources.hpp"

using namespace rayclock;

TEST_CASE("the generated package is current", "[package]") {
    std::ifstream file(rtl_sources() / "rc_pkg.sv");
    std::ostringstream text;
    text << file.rdbuf();
    REQUIRE(file);
    INFO("regenerate with: cmake --build --preset release --target regen");
    REQUIRE((text.str() == rc_package(named_config("default"))));
}

TEST_CASE("the tables of docs/machine/chip.md are current", "[package]") {
    std::ifstream file(rtl_sources().parent_path() / "docs/machine/chip.md");
    std::ostringstream text;
    text << file.rdbuf();
    REQUIRE(file);
    INFO("regenerate with: cmake --build --preset release --target regen");
    REQUIRE((text.str() == with_tables(text.str())));
    for (const char* table : {"registers", "parameters", "frame", "counters", "node", "surface", "hit_t"})
        REQUIRE_THAT(text.str(), Catch::Contains(std::string("<!-- made: ") + table + " -->"));
}

TEST_CASE("docs/guide/configurations.md has every parameter as the table of parameters has it", "[package]") {
    std::ifstream file(rtl_sources().parent_path() / "docs/guide/configurations.md");
    std::ostringstream text;
    text << file.rdbuf();
    REQUIRE(file);
    INFO("regenerate with: cmake --build --preset release --target regen");
    REQUIRE((text.str() == with_tables(text.str())));
    for (const Parameter& p : parameters())
        REQUIRE_THAT(text.str(), Catch::Contains("| `" + std::string(p.key) + "` |"));
}

TEST_CASE("the package states the configuration's numbers", "[package]") {
    Config config = named_config("small");
    config.contexts = 32;
    const std::string text = rc_package(config);
    for (const char* line :
         {"localparam int unsigned Contexts = 32;", "localparam int unsigned CoordBits = 16;",
          "localparam int unsigned RayBits = 5;", "logic [4:0] ray;", "} tri_rsp_t;",
          "logic signed [49:0] num;"})
        REQUIRE_THAT(text, Catch::Contains(line));
}

// Waveforms and routed chips find a unit by the name of its instance.
TEST_CASE("every node unit has an instance of its name", "[package]") {
    std::ostringstream text;
    text << std::ifstream(rtl_sources() / "engine/rc_node_unit.sv").rdbuf();
    const std::string rtl = text.str();
    REQUIRE(rtl.find("    rc_``UNIT u_``UNIT (") != std::string::npos);   // of a row
    for (const NodeUnit& u : node_units) {
        const std::string name = unit_name(u.unit);
        CAPTURE(name);
        const bool has_row = rtl.find("`RC_NODE_UNIT(Structure") != std::string::npos &&
                             rtl.find(", " + name + ")\n") != std::string::npos;
        CHECK((has_row || rtl.find("    rc_" + name + " u_" + name + " (") != std::string::npos));
    }
}
