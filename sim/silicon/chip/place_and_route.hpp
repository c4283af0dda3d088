#pragma once
// Synthesises, places and routes a configuration. The result of each step is kept.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/base/progress.hpp"
#include "model/core/config.hpp"
#include "sim/files/cache/results.hpp"
#include "sim/silicon/chip/board.hpp"
#include "sim/silicon/chip/nextpnr.hpp"
#include "sim/silicon/chip/route.hpp"

namespace rayclock::chip {

/// What to place: the whole chip ("chip"), one unit, or the board around the chip (board_top), with device,
/// seeds and methods.
struct Request {
    Config config;
    std::string top = "chip";
    Device device;
    std::vector<int> seeds;
    Methods methods{};
    int khz = 0;   ///< the chip's clock on the board; 0 without a board

    bool is_board() const { return top == board_top; }
};

/// The results of a request.
struct Result {
    Request request;
    std::map<std::string, Use> units;   ///< after synthesis, before placement
    std::string misfit;                 ///< a sentence if the design does not fit
    /// One route for each seed, in the requested order. Empty if the design does not fit.
    std::vector<Route> routes;
    bool was_kept = false;   ///< all results came from the cache

    bool fits() const { return misfit.empty(); }
    const Route& best() const;   ///< the fastest; of a board, first those that meet all clocks
    std::string bitstream{};     ///< content of board.bit; empty if the best route misses a clock
};

/// Returns a sentence if the units need more than the device has: by how much, and which units are largest.
/// Empty if they fit.
std::string misfit(const std::string& name, const Device& device, const std::map<std::string, Use>& units);

/// Returns the names of the modules that can be placed alone in this configuration.
std::vector<std::string> tops(const Config& config);

/// Runs the missing steps. Throws UserError if a tool is missing, too old or fails, and Interrupted after
/// Ctrl-C. After an interrupt the same request continues after its last finished step.
Result run(const Request& request, results::Cache& cache, const Progress& progress);

/// Returns the kept result of a request; nothing if a seed is missing. Throws UserError if a tool is missing,
/// because its version is part of the key.
std::optional<Result> kept(const Request& request, results::Cache& cache);

}   // namespace rayclock::chip
