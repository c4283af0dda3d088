// Multipliers and block memories get better sites among those in use.
#include <catch2/catch.hpp>

#include <fstream>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/base/error.hpp"
#include "model/base/rng.hpp"
#include "sim/silicon/chip/anchor.hpp"
#include "sim/silicon/chip/cells.hpp"
#include "sim/files/input.hpp"
#include "tests/support/files/test_folder.hpp"

using namespace rayclock;
using namespace rayclock::chip;

namespace {

std::string bel(int x, int y, const char* site) { return fmt::format("X{}/Y{}/{}", x, y, site); }

/// Returns multipliers in one row and memories in another, each connected to registers somewhere.
std::vector<Cell> random_chip(std::uint64_t seed, int movable) {
    Rng rng(seed);
    std::vector<Cell> cells;
    for (int i = 0; i < movable; ++i) {
        cells.push_back({fmt::format("mul{}", i), "MULT18X18D", "", bel(9 * i + 4, 10, "MULT18_0"), {}});
        cells.push_back({fmt::format("ram{}", i), "DP16KD", "", bel(9 * i + 4, 22, "EBR0"), {}});
    }
    const int free = rng.below(3);   // some nets have one more end
    for (int net = 0; net < 12 * movable; ++net) {
        cells[std::size_t(rng.below(2 * movable))].nets.push_back(net);
        for (int end = 0; end <= free; ++end)
            cells.push_back({fmt::format("ff{}_{}", net, end),
                             "TRELLIS_FF",
                             "",
                             bel(rng.below(9 * movable), rng.below(40), "SLICEA.FF0"),
                             {net}});
    }
    for (int net = 0; net < 6 * movable; ++net)   // some nets connect two of them
        for (int end = 0; end < 2; ++end)
            cells[std::size_t(rng.below(2 * movable))].nets.push_back(100000 + net);
    return cells;
}

std::vector<Cell> moved(std::vector<Cell> cells, const std::map<std::string, std::string>& sites) {
    for (Cell& cell : cells)
        if (const auto found = sites.find(cell.name); found != sites.end()) cell.bel = found->second;
    return cells;
}

}   // namespace

TEST_CASE("half the perimeter of each net's bounding box is a wire's length") {
    CHECK(wire_length({{"a", "TRELLIS_FF", "", "X1/Y2/SLICEA.FF0", {1, 2}},
                       {"b", "TRELLIS_FF", "", "X4/Y2/SLICEA.FF0", {1}},
                       {"c", "TRELLIS_FF", "", "X3/Y9/SLICEB.FF0", {1, 3}}}) == 3 + 7);
}

TEST_CASE("multipliers that lie each at the other's registers are exchanged") {
    const std::vector<Cell> cells{{"left", "MULT18X18D", "", "X104/Y58/MULT18_0", {1}},
                                  {"right", "MULT18X18D", "", "X5/Y58/MULT18_1", {2}},
                                  {"ram", "DP16KD", "", "X60/Y22/EBR0", {3}},
                                  {"l", "TRELLIS_FF", "", "X6/Y57/SLICEA.FF0", {1}},
                                  {"r", "TRELLIS_FF", "", "X103/Y57/SLICEA.FF0", {2}},
                                  {"m", "TRELLIS_FF", "", "X2/Y2/SLICEA.FF0", {3}}};
    CHECK(anchors(cells) == std::map<std::string, std::string>{{"left", "X5/Y58/MULT18_1"},
                                                               {"right", "X104/Y58/MULT18_0"},
                                                               {"ram", "X60/Y22/EBR0"}});
}

TEST_CASE("anchors are the sites that were used, one each, and wires are no longer than before") {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const std::vector<Cell> cells = random_chip(seed, 1 + int(seed % 9));
        const auto sites = anchors(cells);
        std::multiset<std::string> before, after;
        for (const Cell& cell : cells)
            if (cell.type != "TRELLIS_FF") before.insert(cell.bel);
        for (const auto& [name, site] : sites) {
            after.insert(site);
            CHECK((site.find("EBR") != std::string::npos) == name.starts_with("ram"));
        }
        INFO("seed " << seed);
        CHECK(before == after);
        CHECK(wire_length(moved(cells, sites)) <= wire_length(cells));
        if (seed % 9 >= 4) CHECK(wire_length(moved(cells, sites)) < wire_length(cells));
    }
}

TEST_CASE("a netlist's cells are wired as its text says") {
    const test::TestFolder folder;
    std::ofstream(folder.name("a.json")) << R"({"modules": {"top": {"attributes": {"x": 9}, "cells": {
        "u_a": {"type": "LUT4", "connections": {"A": [ 2 ], "B": [ "0" ], "Z": [ 17, 3 ]}, "hide_name": 1},
        "u_b": {"type": "LUT4", "connections": {}}}}}})";
    std::vector<std::vector<int>> nets;
    REQUIRE(read_cells(folder.name("a.json"), [&](const Cell& cell) { nets.push_back(cell.nets); }));
    CHECK(nets == std::vector<std::vector<int>>{{2, 17, 3}, {}});
}

TEST_CASE("a netlist gets anchors as attributes, and nothing else changes") {
    const test::TestFolder folder;
    const std::string text = R"({
  "modules": {
    "top": {
      "cells": {
        "u_mul": {
          "type": "MULT18X18D",
          "attributes": {
            "src": "rc_mul.sv:1.1"
          },
          "connections": {
            "A0": [ 2 ]
          }
        },
        "u_ram": {
          "type": "DP16KD",
          "attributes": {
          }
        },
        "u_ff": {
          "type": "TRELLIS_FF",
          "attributes": {
          }
        }
      }
    }
  }
}
)";
    std::ofstream(folder.name("a.json")) << text;
    const std::map<std::string, std::string> sites{{"u_mul", "X4/Y10/MULT18_0"}, {"u_ram", "X4/Y22/EBR0"}};
    write_anchored(folder.name("a.json"), folder.name("b.json"), sites);
    nlohmann::json expected = nlohmann::json::parse(text);
    for (const auto& [name, site] : sites)
        expected["modules"]["top"]["cells"][name]["attributes"]["BEL"] = site;
    CHECK(nlohmann::json::parse(read_if_there(folder.name("b.json"))) == expected);
    CHECK_THROWS_AS(write_anchored(folder.name("a.json"), folder.name("c.json"), {{"u_no", "X1/Y1/EBR0"}}),
                    UserError);
    CHECK_THROWS_AS(anchors_of(folder.name("none.json")), UserError);
}
