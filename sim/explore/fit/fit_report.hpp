#pragma once
// Results of fit as text and as JSON. docs/guide/report.md explains every key.
#include <nlohmann/json.hpp>
#include <string>

#include "sim/explore/fit/ranges.hpp"
#include "sim/explore/fit/search.hpp"

namespace rayclock::fit {

/// Returns a table of the parameters: width, purpose, and the effect of one step less.
std::string parameter_table(const Fit& fit, const Config& base);
/// Returns the memory that the scene needs, off and on the chip, and the cost of the formats. If `ranges` is
/// empty, fit has proven nothing.
std::string needs_text(const Fit& fit, const Config& base, const Ranges& ranges);
/// Returns the units that the scene needs, and the features that the machine leaves out.
std::string units_text(const Config& config);
/// Returns a table of all signals: interval, bits needed, bits present.
std::string range_table(const Ranges& ranges);

nlohmann::ordered_json parameters_json(const Fit& fit, const Config& base);
nlohmann::ordered_json needs_json(const Fit& fit, const Ranges& ranges);
nlohmann::ordered_json units_json(const Config& config);
nlohmann::ordered_json cost_json(const Cost& cost);
nlohmann::ordered_json ranges_json(const Ranges& ranges);
nlohmann::ordered_json outcome_json(const Measurement& outcome);

}   // namespace rayclock::fit
