#pragma once
// One seed of a netlist: placed, routed, and read back.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/silicon/chip/device.hpp"

namespace rayclock::chip {

/// A slow path, by units and registers.
struct PathRow {
    double ns = 0, logic_ns = 0;
    int levels = 0;
    std::string from_unit, from, to_unit, to;
    std::string source;   ///< "rtl/engine/bvh/rc_box.sv:120" of where it ends
    double mhz() const { return 1000 / ns; }
};

/// How many cells of a unit lie in a tile.
struct Tile {
    int x = 0, y = 0;
    std::string unit;
    Use use;
};

struct Route {
    int seed = 0;
    double fmax_mhz = 0;
    std::vector<PathRow> paths;         ///< the slowest first
    std::map<std::string, Use> units;   ///< as placed; the harness is one of them
    std::vector<Tile> tiles;
};

nlohmann::ordered_json route_json(const Route& route);
Route route_of(const nlohmann::ordered_json& json);

/// From report.json, placed.json and delays.sdf of a folder. `top` is what the harness holds. Throws
/// UserError if they are not whole.
Route read_route(const std::filesystem::path& folder, const std::string& top, int seed);

/// MHz of the one clock in report.json. Throws UserError if it is not as nextpnr writes it.
double fmax_of(const std::string& report);

/// All but the harness.
Use total_of(const std::map<std::string, Use>& units);

}   // namespace rayclock::chip
