// Reads nextpnr's results: clock, paths, cells by unit and tiles.
#include "sim/silicon/chip/route.hpp"

#include <algorithm>
#include <functional>
#include <sstream>
#include <tuple>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/input.hpp"
#include "sim/files/json_form.hpp"
#include "sim/run/rtl/sources.hpp"
#include "sim/silicon/chip/board.hpp"
#include "sim/silicon/chip/cells.hpp"
#include "sim/silicon/chip/timing.hpp"

namespace rayclock::chip {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr std::size_t max_paths = 5;

[[noreturn]] void not_whole(const fs::path& file) {
    throw UserError(file.filename().string() + " of nextpnr-ecp5 is not whole; is the disk full?");
}

/// Converts a path. Bits of one register give the same row.
PathRow row_of(const Path& path, const Units& units) {
    PathRow row;
    row.ns = path.ns, row.logic_ns = path.logic, row.levels = path.levels;
    row.from_unit = units.of(path.from), row.to_unit = units.of(path.to);
    row.from = register_of(path.from, row.from_unit), row.to = register_of(path.to, row.to_unit);
    return row;
}

std::vector<Path> paths_of(const fs::path& file, const Units& units) {
    const std::string text = read_if_there(file);
    if (text.find("\n)") == std::string::npos) not_whole(file);   // the file's last line
    try {
        return slowest_paths(text, max_paths, [&](const Path& path) {
            const PathRow row = row_of(path, units);
            return row.from_unit + "." + row.from + " " + row.to_unit + "." + row.to;
        });
    } catch (const std::runtime_error&) {
        not_whole(file);
    }
}

/// "X107/Y74/SLICEC.RAMW" -> 107, 74.
bool place_of(const std::string& bel, int& x, int& y) {
    return std::sscanf(bel.c_str(), "X%d/Y%d/", &x, &y) == 2;
}

}   // namespace

std::vector<Clock> clocks_of(const std::string& report) {
    const std::string name = "report.json of nextpnr-ecp5";
    if (report.empty()) throw UserError(name + " is not whole; is the disk full?");
    const Json document = parse_json(name, report);
    const JsonValue clocks = JsonValue(document, name).at("fmax").object();
    if (clocks.size() == 0) clocks.expected("an object with clocks");
    std::vector<Clock> all;
    for_each(clocks, [&](const std::string& net, const JsonValue& clock) {
        const auto mhz = [&](const char* key) {
            const double value = clock.at(key).number();
            if (!(value > 0 && value < 100'000)) clock.at(key).expected("a clock in MHz");
            return value;
        };
        const std::size_t at = net.rfind('$');   // "$glbnet$clk"
        all.push_back({at == net.npos ? net : net.substr(at + 1), mhz("achieved"), mhz("constraint")});
    });
    return all;
}

namespace {

/// Returns the chip's clock. A unit or chip alone has only one; on a board it is the net "clk".
const Clock& chip_clock(const std::vector<Clock>& clocks, const std::string& top) {
    for (const Clock& clock : clocks)
        if (clocks.size() == 1 || (top == board_top && clock.name == "clk")) return clock;
    throw UserError(
        fmt::format("report.json of nextpnr-ecp5 has {} clocks, and none is the chip's", clocks.size()));
}

}   // namespace

bool Route::meets_clocks() const {
    return std::all_of(clocks.begin(), clocks.end(), std::mem_fn(&Clock::is_met));
}

Use total_of(const std::map<std::string, Use>& units) {
    Use all;
    for (const auto& [unit, use] : units)
        if (unit != harness_unit) all += use;
    return all;
}

Route read_route(const fs::path& folder, const std::string& top, int seed) {
    Route route;
    route.seed = seed;
    const std::vector<Clock> clocks = clocks_of(read_if_there(folder / "report.json"));
    route.fmax_mhz = chip_clock(clocks, top).achieved;
    if (top == board_top) route.clocks = clocks;
    const Units units(top);
    const std::vector<Path> paths = paths_of(folder / "delays.sdf", units);
    std::map<std::string, std::string> sources;   // source positions of the cells at the ends of these paths
    for (const Path& path : paths) sources[path.from], sources[path.to];
    std::map<std::tuple<int, int, std::string>, Use> tiles;
    const bool whole = read_cells((folder / "placed.json").string(), [&](const Cell& cell) {
        if (const auto at = sources.find(cell.name); at != sources.end()) at->second = cell.source;
        const Use use = use_of(cell.type);
        int x = 0, y = 0;
        if (use == Use{} || !place_of(cell.bel, x, y)) return;
        const std::string unit = units.of(cell.name);
        route.units[unit] += use;
        tiles[{x, y, unit}] += use;
    });
    if (!whole || route.units.empty()) not_whole(folder / "placed.json");
    const std::string rtl = fs::absolute(rtl_sources()).string();
    for (const Path& path : paths) {
        route.paths.push_back(row_of(path, units));
        PathRow& row = route.paths.back();
        row.source = source_line(sources[path.to], rtl);
        if (row.source.empty()) row.source = source_of_name(row.to_unit, row.to, rtl);
        if (row.source.empty()) row.source = source_line(sources[path.to], rtl, true);
    }
    for (const auto& [place, use] : tiles)
        route.tiles.push_back({std::get<0>(place), std::get<1>(place), std::get<2>(place), use});
    return route;
}

ordered_json route_json(const Route& route) {
    ordered_json units = ordered_json::object(), paths = ordered_json::array();
    for (const auto& [unit, use] : route.units) units[unit] = {use.lut, use.ff, use.dsp, use.bram};
    for (const PathRow& p : route.paths)
        paths.push_back({p.ns, p.logic_ns, p.levels, p.from_unit, p.from, p.to_unit, p.to, p.source});
    // Stored as one text: the tens of thousands of tiles then take a tenth of the space.
    std::string tiles;
    for (const Tile& t : route.tiles)
        tiles += fmt::format("{} {} {} {} {} {} {}\n", t.x, t.y, t.unit, t.use.lut, t.use.ff, t.use.dsp,
                             t.use.bram);
    ordered_json clocks = ordered_json::array();
    for (const Clock& c : route.clocks) clocks.push_back({c.name, c.achieved, c.target});
    return {{"seed", route.seed}, {"fmax_mhz", route.fmax_mhz},
            {"clocks", clocks},   {"units", units},
            {"paths", paths},     {"tiles", tiles}};
}

Route route_of(const ordered_json& json) {
    Route route;
    route.seed = json.at("seed").get<int>();
    route.fmax_mhz = json.at("fmax_mhz").get<double>();
    if (json.contains("clocks"))   // results of older versions have none
        for (const ordered_json& c : json.at("clocks"))
            route.clocks.push_back(
                {c.at(0).get<std::string>(), c.at(1).get<double>(), c.at(2).get<double>()});
    for (const auto& [unit, use] : json.at("units").items())
        route.units[unit] = {use.at(0).get<std::uint64_t>(), use.at(1).get<std::uint64_t>(),
                             use.at(2).get<std::uint64_t>(), use.at(3).get<std::uint64_t>()};
    for (const ordered_json& p : json.at("paths")) {
        PathRow row;
        p.at(0).get_to(row.ns), p.at(1).get_to(row.logic_ns), p.at(2).get_to(row.levels);
        p.at(3).get_to(row.from_unit), p.at(4).get_to(row.from);
        p.at(5).get_to(row.to_unit), p.at(6).get_to(row.to), p.at(7).get_to(row.source);
        route.paths.push_back(row);
    }
    std::istringstream tiles(json.at("tiles").get<std::string>());
    Tile t;
    while (tiles >> t.x >> t.y >> t.unit >> t.use.lut >> t.use.ff >> t.use.dsp >> t.use.bram)
        route.tiles.push_back(t);
    return route;
}

}   // namespace rayclock::chip
