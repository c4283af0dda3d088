#pragma once
// A placed chip as text for people and as JSON; every key is explained in docs/report.md.
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/silicon/chip/run.hpp"

namespace rayclock::chip {

/// One chip, or one unit: cells by unit, clock by seed, slowest paths.
std::string text(const Result& result);
nlohmann::ordered_json json(const Result& result);

/// Several units, each placed alone: a row for each.
std::string table(const std::vector<Result>& alone);

}   // namespace rayclock::chip
