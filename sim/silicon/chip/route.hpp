#pragma once
// The result of one seed: a netlist placed, routed and read back.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/silicon/chip/device.hpp"

namespace rayclock::chip {

/// A slow path, described by units and registers.
struct PathRow {
    double ns = 0, logic_ns = 0;
    int levels = 0;
    std::string from_unit, from, to_unit, to;
    std::string source;   ///< position of the path's end: "rtl/engine/bvh/rc_box.sv:120"
    double mhz() const { return 1000 / ns; }
};

/// The cells of one unit in a tile.
struct Tile {
    int x = 0, y = 0;
    std::string unit;
    Use use;
};

/// A clock after routing, in MHz.
struct Clock {
    std::string name;   ///< net in the top module: "shift_clk"
    double achieved = 0, target = 0;
    bool is_met() const { return achieved >= target; }
};

/// The routed netlist of one seed.
struct Route {
    int seed = 0;
    double fmax_mhz = 0;                ///< of the chip's clock
    std::vector<Clock> clocks;          ///< of a board: all of them
    bool meets_clocks() const;          ///< true if every clock of a board reaches its target
    std::vector<PathRow> paths;         ///< the slowest first
    std::map<std::string, Use> units;   ///< after placement, including the harness
    std::vector<Tile> tiles;
};

nlohmann::ordered_json route_json(const Route& route);
Route route_of(const nlohmann::ordered_json& json);

/// Reads report.json, placed.json and delays.sdf of a folder. `top` is the content of the harness. Throws
/// UserError if a file is incomplete.
Route read_route(const std::filesystem::path& folder, const std::string& top, int seed);

/// Returns the clocks in report.json, at least one. Throws UserError if the text is not in nextpnr's format.
std::vector<Clock> clocks_of(const std::string& report);

/// Returns the sum over all units except the harness.
Use total_of(const std::map<std::string, Use>& units);

}   // namespace rayclock::chip
