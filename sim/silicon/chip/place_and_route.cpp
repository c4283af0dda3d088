// Runs the steps from a configuration to routed clocks, and caches the result of each step.
#include "sim/silicon/chip/place_and_route.hpp"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/quote.hpp"
#include "model/base/split.hpp"
#include "sim/files/input.hpp"
#include "sim/files/process/interrupt.hpp"
#include "sim/files/table.hpp"
#include "sim/run/gen/ecp5.hpp"
#include "sim/run/gen/rc_pkg.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/silicon/area/variants.hpp"
#include "sim/silicon/chip/cells.hpp"
#include "sim/silicon/chip/clock.hpp"
#include "sim/silicon/chip/harness.hpp"
#include "sim/silicon/synth/parts.hpp"
#include "sim/silicon/synth/yosys.hpp"

namespace rayclock::chip {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

[[noreturn]] void stopped() {
    throw Interrupted("interrupted: finished steps are kept, and the same command continues after them");
}

/// Runs Yosys in a temporary folder.
void run_yosys(const synth::YosysFolder& folder, const Config& config, const std::string& script,
               RtlScope scope = RtlScope::chip) {
    if (!folder.run(config, "-defer ", script, scope)) stopped();
}

/// Optimises each unit alone and joins the units at the end, so that each cell keeps its unit's name.
/// Optimisation across units gains little: `small` has 23,216 LUT4 with this script and 23,298 with the
/// other.
std::string synth_script(const std::string& top, const std::string& units,
                         const std::string& at_the_end = {}) {
    return fmt::format(
        "read_verilog -sv harness.v\n"
        "hierarchy -check -top {}\n"
        "setattr -mod -set keep_hierarchy 1 {}\n"
        "{}"
        "setattr -mod -unset keep_hierarchy *\n"
        "flatten\n"
        "opt_clean\n"
        "{}"
        "write_json netlist.json\n",
        top, units, ecp5_steps(), at_the_end);
}

class Steps {
public:
    Steps(const Request& request, results::Cache& cache, const Progress& progress)
        : request_(request), cache_(cache), progress_(progress) {}

    Result run() {
        Result result{request_, {}, {}, {}, true};
        find_ports();
        const auto units = known_units();
        result.units = units ? *units : synthesize();
        result.was_kept = units.has_value();
        result.misfit = misfit(request_.config.name, request_.device, result.units);
        for (const int seed : request_.seeds) {
            if (!result.fits()) break;
            const auto known = known_route(seed);
            result.was_kept &= known.has_value();
            if (known)
                result.routes.push_back(*known);
            else
                route(seed, result);
        }
        if (result.fits() && result.routes.empty())
            result.misfit = fmt::format(
                "'{}' cannot be routed on {}: {}; another seed, another placer or more placements may help",
                printable(request_.config.name), request_.device.name, stuck_);
        if (request_.is_board() && result.fits() && result.best().meets_clocks())
            result.bitstream = read_file(bitstream(result.best().seed));
        return result;
    }

    /// Returns the result if all of it is kept; nothing if anything is missing.
    std::optional<Result> kept() {
        Result result{request_, {}, {}, {}, true};
        find_ports();
        const auto units = known_units();
        if (!units) return std::nullopt;
        result.units = *units;
        result.misfit = misfit(request_.config.name, request_.device, result.units);
        for (const int seed : request_.seeds) {
            if (!result.fits()) break;
            const auto known = known_route(seed);
            if (!known) return std::nullopt;
            result.routes.push_back(*known);
        }
        return result;
    }

private:
    void report_progress(const std::string& what, int percent) const {
        if (progress_) progress_(fmt::format("{}, {}", request_.top, what), std::uint64_t(percent), 100);
    }

    /// Finds the ports and modules. They give the key of all later steps: the package, the sources of these
    /// modules only, and the synthesis script.
    void find_ports() {
        if (request_.is_board()) {
            find_board();
            return;
        }
        const std::string package = results::hash_text(rc_package(request_.config));
        const std::string key = fmt::format("package {} rtl {} top {} {}", package, synth::rtl_digest(),
                                            request_.top, synth::yosys_version());
        if (const auto known = cache_.find("chip-interface", key, [](const ordered_json& json) {
                return std::tuple(json.at("harness").get<std::string>(),
                                  json.at("modules").get<std::string>(), json.at("units").get<std::string>());
            })) {
            std::tie(harness_, modules_, units_) = *known;
        } else {
            const synth::YosysFolder folder(cache_.folder());
            run_yosys(
                folder, request_.config,
                synth::elaborate(request_.config, request_.top) + "blackbox =*\nwrite_json interface.json\n");
            const ModuleInterface interface = interface_of(folder.text("interface.json"), request_.top);
            harness_ = harness_text(request_.config, request_.top, interface);
            std::string texts;
            for (const fs::path& file : rtl_files())
                for (const std::string& module : interface.modules)
                    if (file.filename() == "rc_" + module + ".sv")
                        texts += synth::synthesised_text(read_if_there(file));
            modules_ = results::hash_text(texts);
            units_ = units_of(interface);
            cache_.keep("chip-interface", key,
                        {{"harness", harness_}, {"modules", modules_}, {"units", units_}});
        }
        design_ = fmt::format("top {} of copies package {} modules {} harness {} script {} {}", request_.top,
                              package, modules_, results::hash_text(harness_), results::hash_text(script()),
                              synth::yosys_version());
    }

    /// The same for a board. Its ports are those of rc_ulx3s.v, and all sources are part of the key.
    void find_board() {
        harness_ = board_verilog();
        top_ = "rc_ulx3s " + board_parameters(request_.config, request_.khz);
        pins_ = board_pins();
        units_ =
            "*rc_board* *rc_chip* *rc_host* *rc_host_link* *rc_frame_control* *rc_pixel_* *rc_scan_out* "
            "*rc_video*";
        for (const area::UnitRow& row : area::unit_rows())
            if (row.is_there(request_.config)) units_ += fmt::format(" *rc_{}*", row.name);
        design_ =
            fmt::format("board package {} rtl {} harness {} pins {} script {} {} {}",
                        results::hash_text(rc_package(request_.config)), synth::rtl_digest(RtlScope::board),
                        results::hash_text(harness_), results::hash_text(pins_), results::hash_text(script()),
                        synth::yosys_version(), packer_version());
    }

    /// Returns patterns of Yosys for the modules that stay separate: the top module and the units in it.
    std::string units_of(const ModuleInterface& interface) const {
        std::string patterns = fmt::format("*rc_{}*", request_.top);
        const auto add = [&](const std::string& unit) {
            const bool there = std::find(interface.modules.begin(), interface.modules.end(), unit) !=
                               interface.modules.end();
            if (there && unit != request_.top) patterns += fmt::format(" *rc_{}*", unit);
        };
        for (const area::UnitRow& row : area::unit_rows()) add(row.name);
        add("host");
        return patterns;
    }

    std::optional<std::map<std::string, Use>> known_units() const {
        return cache_.find("chip-netlist", design_, [](const ordered_json& json) {
            std::map<std::string, Use> units;
            for (const auto& [unit, use] : json.items())
                units[unit] = {use.at(0).get<std::uint64_t>(), use.at(1).get<std::uint64_t>(),
                               use.at(2).get<std::uint64_t>(), use.at(3).get<std::uint64_t>()};
            return units;
        });
    }

    std::string script() const {
        return synth_script(top_, units_, request_.is_board() ? pin_registers() : "");
    }

    fs::path netlist() const {
        return cache_.folder() / fmt::format("chip-netlist-{}.netlist", results::hash_text(design_));
    }

    /// Writes the netlist, which is kept complete or not at all, and returns the resources of its units.
    std::map<std::string, Use> synthesize() {
        report_progress("synthesis", 0);
        const synth::YosysFolder folder(cache_.folder());
        folder.write("harness.v", harness_);
        run_yosys(folder, request_.config, script(), request_.is_board() ? RtlScope::board : RtlScope::chip);
        const Units names(request_.top);
        std::map<std::string, Use> units;
        const bool whole = read_cells(folder.path("netlist.json").string(), [&](const Cell& cell) {
            units[names.of(cell.name)] += use_of(cell.type);
        });
        if (!whole) throw UserError("netlist.json of yosys is not whole; is the disk full?");
        std::error_code error;
        fs::rename(folder.path("netlist.json"), netlist(), error);
        if (error) throw UserError(fmt::format("{}: {}", netlist().string(), error.message()));
        ordered_json json;
        for (const auto& [unit, use] : units) json[unit] = {use.lut, use.ff, use.dsp, use.bram};
        cache_.keep("chip-netlist", design_, json);
        report_progress("synthesis", 100);
        return units;
    }

    std::string route_key(int seed) const {
        const int placements = request_.methods.placements;
        const std::string first = nextpnr_options(request_.device, request_.methods),
                          last = nextpnr_options(request_.device, request_.methods, true);
        // Older results with three or more placements, kept as "then", used heap in all but the first.
        return fmt::format("{} nextpnr {} {} seed {} read 5{}{}", design_, nextpnr().version, first, seed,
                           placements == 1 ? "" : fmt::format(" placements {}", placements),
                           last == first ? "" : (placements == 2 ? " then " : " at last ") + last);
    }

    /// Returns the key of a placement's sites. It excludes the router and the number of later placements.
    std::string sites_key(int seed, int placement) const {
        Methods methods = request_.methods;
        methods.router = Methods{}.router;
        return fmt::format("{} nextpnr {} {} seed {} placement {} exchanged 1", design_, nextpnr().version,
                           nextpnr_options(request_.device, methods), seed, placement);
    }

    fs::path bitstream(int seed) const {
        return cache_.folder() / fmt::format("chip-bitstream-{}.bit", results::hash_text(route_key(seed)));
    }

    /// Returns a route that is kept, with its bitstream if it needs one.
    std::optional<Route> known_route(int seed) const {
        if (request_.is_board() && !fs::exists(bitstream(seed))) return std::nullopt;
        return cache_.find("chip-route", route_key(seed), route_of);
    }

    KeptSites kept_sites(int seed) const {
        const auto find = [this, seed](int placement) {
            return cache_.find("chip-sites", sites_key(seed, placement),
                               [](const ordered_json& json) { return json.get<Sites>(); });
        };
        const auto keep = [this, seed](int placement, const Sites& sites) {
            cache_.keep("chip-sites", sites_key(seed, placement), sites);
        };
        return {find, keep};
    }

    void route(int seed, Result& result) {
        if (!fs::exists(netlist())) synthesize();
        const synth::YosysFolder folder(cache_.folder());
        std::error_code error;
        fs::create_hard_link(netlist(), folder.path("netlist.json"), error);
        if (error) fs::copy_file(netlist(), folder.path("netlist.json"), error);
        if (error) throw UserError(fmt::format("{}: {}", netlist().string(), error.message()));
        const auto hear = [&](const std::string& what, int percent) {
            report_progress(fmt::format("seed {}, {}", seed, what), percent);
        };
        const fs::path place = folder.path("netlist.json").parent_path();
        if (request_.is_board()) folder.write(pins_file, pins_);
        const RouteEnd end = run_nextpnr(place, request_.device, request_.methods, seed, request_.is_board(),
                                         kept_sites(seed), hear);
        if (end == RouteEnd::interrupted) stopped();
        if (end == RouteEnd::does_not_route) {   // another seed may route
            hear_stuck(step_of_log(read_if_there(place / "log")));
            return;
        }
        if (end == RouteEnd::does_not_fit) {
            result.misfit = fmt::format("'{}' does not fit {}: the placer finds no place for all cells",
                                        printable(request_.config.name), request_.device.name);
            return;
        }
        const Route route = read_route(place, request_.top, seed);
        if (request_.is_board()) {
            pack_bitstream(place, textual_file, "board.bit");
            fs::rename(place / "board.bit", bitstream(seed), error);
            if (error) throw UserError(fmt::format("{}: {}", bitstream(seed).string(), error.message()));
        }
        cache_.keep("chip-route", route_key(seed), route_json(route));
        hear("done", 100);
        result.routes.push_back(route);
    }

    /// Keeps the message of the seed that came closest.
    void hear_stuck(const RouteStep& step) {
        const std::pair left{step.tool == "static", step.least_left};   // a seed that was placed came closer
        if (!stuck_.empty() && left_ <= left) return;
        left_ = left;
        stuck_ = step.stuck();
    }

    const Request& request_;
    results::Cache& cache_;
    const Progress& progress_;
    std::string harness_, modules_, units_, design_;
    std::string top_ = "rc_harness", pins_;   ///< Yosys' top with parameters; the pins of a board
    std::string stuck_;                       ///< why no seed could be routed
    /// Of that seed: whether its placement failed, and RouteStep::least_left.
    std::pair<bool, long> left_;
};

}   // namespace

std::string misfit(const std::string& name, const Device& device, const std::map<std::string, Use>& units) {
    Use all;
    for (const auto& [unit, use] : units) all += use;   // the harness also needs resources
    std::vector<std::string> parts;
    for (const Resource& resource : resources()) {
        const std::uint64_t has = device.has.*resource.member, needs = all.*resource.member;
        if (needs <= has) continue;
        const auto largest = std::max_element(units.begin(), units.end(), [&](const auto& a, const auto& b) {
            return a.second.*resource.member < b.second.*resource.member;
        });
        parts.push_back(fmt::format("{} {} of {} ({} too many; narrow {}, which takes {})", grouped(needs),
                                    resource.name, grouped(has), grouped(needs - has), largest->first,
                                    grouped(largest->second.*resource.member)));
    }
    if (parts.empty()) return {};
    return fmt::format("'{}' does not fit {}: it needs {}", printable(name), device.name,
                       fmt::join(parts, ", "));
}

const Route& Result::best() const {
    return *std::max_element(routes.begin(), routes.end(), [](const Route& a, const Route& b) {
        return std::pair(a.meets_clocks(), a.fmax_mhz) < std::pair(b.meets_clocks(), b.fmax_mhz);
    });
}

std::vector<std::string> tops(const Config& config) {
    std::vector<std::string> names{"chip"};
    for (const area::UnitRow& row : area::unit_rows())
        if (row.is_there(config)) names.push_back(row.name);
    return names;
}

namespace {

void check_tools() {
    if (synth::yosys_version().empty())
        throw UserError("yosys is not installed, and netlists come from it: apt-get install yosys");
    if (!nextpnr().problem.empty()) throw UserError(nextpnr().problem);
}

}   // namespace

Result run(const Request& request, results::Cache& cache, const Progress& progress) {
    check_tools();
    if (!cache.trouble().empty()) throw UserError(cache.trouble());
    const Result result = Steps(request, cache, progress).run();
    if (request.top == "chip" && !result.routes.empty())
        keep_clock(request.config, {result.best().fmax_mhz, request.device.name, result.best().seed}, cache);
    return result;
}

std::optional<Result> kept(const Request& request, results::Cache& cache) {
    check_tools();
    return Steps(request, cache, {}).kept();
}

}   // namespace rayclock::chip
