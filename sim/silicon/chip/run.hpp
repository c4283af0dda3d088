#pragma once
// From a configuration to routed clocks: synthesis, placement, routing. What is done is kept step by step.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/base/progress.hpp"
#include "model/core/config.hpp"
#include "sim/silicon/chip/nextpnr.hpp"
#include "sim/silicon/chip/route.hpp"
#include "sim/files/cache/results.hpp"

namespace rayclock::chip {

/// What is placed: the whole chip ("chip"), or a unit alone.
struct Request {
    Config config;
    std::string top = "chip";
    Device device;
    std::vector<int> seeds;
    Methods methods{};
};

struct Result {
    Request request;
    std::map<std::string, Use> units;   ///< after synthesis, before placement
    std::string misfit;                 ///< a sentence if it does not fit
    std::vector<Route> routes;          ///< by seed, in the order asked for; none if it does not fit
    bool was_kept = false;              ///< nothing had to be worked out

    bool fits() const { return misfit.empty(); }
    const Route& best() const;   ///< the fastest
};

/// A sentence if what these units need is more than the device has: by how much, and which takes most. Empty
/// if it fits.
std::string misfit(const std::string& name, const Device& device, const std::map<std::string, Use>& units);

/// Names of what can be placed alone in this configuration.
std::vector<std::string> tops(const Config& config);

/// Runs what is missing. Throws UserError if a tool is missing, too old or fails, or if interrupted(): then
/// the same request goes on after the last step that was finished.
Result run(const Request& request, jobs::Cache& cache, const Progress& progress);

/// What is kept of a request; nothing if a seed is missing. Throws UserError if a tool is missing: its
/// version is part of the key.
std::optional<Result> kept(const Request& request, jobs::Cache& cache);

}   // namespace rayclock::chip
