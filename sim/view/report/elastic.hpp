#pragma once
// The result of an elastic verification as text and JSON.
#include <nlohmann/json.hpp>
#include <string>

#include "sim/run/elastic/elastic.hpp"

namespace rayclock {

/// Returns the comparison of values, and the RTL's cost beside the model's: cycles, frames per second, and
/// the units whose accounts differ.
std::string elastic_lines(const Config& config, int khz, const ElasticResult& result);

/// Returns the report's object `elastic`; see docs/report.md. `units` is the list as typed.
nlohmann::ordered_json elastic_json(const Config& config, int khz, const std::string& units,
                                    const ElasticResult& result);

}   // namespace rayclock
