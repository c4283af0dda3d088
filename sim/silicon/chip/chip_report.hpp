#pragma once
// A placed chip as text and as JSON. docs/guide/report.md explains every key.
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/silicon/chip/place_and_route.hpp"

namespace rayclock::chip {

/// Formats one chip or one unit: cells by unit, clock by seed, and the slowest paths.
std::string text(const Result& result);
nlohmann::ordered_json json(const Result& result);

/// Returns a table of units that were placed alone, with a row for each.
std::string table(const std::vector<Result>& alone);

}   // namespace rayclock::chip
