#pragma once
// What a chip will take and how fast it will be, from figures of its units that are kept: in seconds.
#include "sim/silicon/chip/run.hpp"

namespace rayclock::chip {

struct Estimate {
    std::map<std::string, Use> units;   ///< of all pipelines
    Use all;
    double fmax_mhz = 0;            ///< of the slowest unit
    std::string slowest;            ///< its name
    std::optional<Result> routed;   ///< the chip itself, if it was routed: how far the estimate is off
};

/// `request` is for the whole chip. Throws UserError with the command to run if a unit was not routed.
Estimate estimate(const Request& request, jobs::Cache& cache, const Progress& progress);

std::string text(const Estimate& estimate, const Request& request);
nlohmann::ordered_json json(const Estimate& estimate, const Request& request);

}   // namespace rayclock::chip
