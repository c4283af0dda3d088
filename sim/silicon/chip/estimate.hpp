#pragma once
// Estimates the area and the clock of a chip from kept results of its units. Takes seconds.
#include "sim/silicon/chip/place_and_route.hpp"

namespace rayclock::chip {

/// The estimate for one chip.
struct Estimate {
    std::map<std::string, Use> units;   ///< summed over all pipelines
    Use all;
    double fmax_mhz = 0;            ///< clock of the slowest unit
    std::string slowest;            ///< its name
    std::optional<Result> routed;   ///< the routed chip, if it exists; shows the error of the estimate
};

/// Returns the estimate; `request` must be for the whole chip. If a unit was not routed, throws UserError
/// with the command to run.
Estimate estimate(const Request& request, results::Cache& cache, const Progress& progress);

std::string text(const Estimate& estimate, const Request& request);
nlohmann::ordered_json json(const Estimate& estimate, const Request& request);

}   // namespace rayclock::chip
