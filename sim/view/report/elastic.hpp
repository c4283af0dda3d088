#pragma once
// The result of an elastic verification as text and JSON.
#include <nlohmann/json.hpp>
#include <string>

#include "sim/run/elastic/elastic.hpp"

namespace rayclock {

/// Returns the comparison of values, and a table with the figures of model and RTL: cycles, frames per
/// second, hit rates, and the account of every unit.
std::string elastic_lines(const Config& config, int khz, const ElasticResult& result);

/// Returns the report's object `elastic`; see docs/guide/report.md. `units` is the list as typed.
nlohmann::ordered_json elastic_json(const Config& config, int khz, const std::string& units,
                                    const ElasticResult& result);

}   // namespace rayclock
