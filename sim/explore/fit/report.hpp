#pragma once
// What fit found out, as text for people and as JSON; every key is explained in docs/report.md.
#include <nlohmann/json.hpp>
#include <string>

#include "sim/explore/fit/ranges.hpp"
#include "sim/explore/fit/search.hpp"

namespace rayclock::fit {

/// Which parameters have which width, why, and what happens one step below.
std::string parameter_table(const Fit& fit, const Config& base);
/// Memory that the scene needs, off and on the chip, and the cost of the formats. If `ranges` is
/// empty, fit has proven nothing.
std::string needs_text(const Fit& fit, const Config& base, const Ranges& ranges);
/// Which units the scene needs, and what the machine leaves out.
std::string units_text(const Config& config);
/// Every signal: interval, bits needed, bits there.
std::string range_table(const Ranges& ranges);

nlohmann::ordered_json parameters_json(const Fit& fit, const Config& base);
nlohmann::ordered_json needs_json(const Fit& fit, const Ranges& ranges);
nlohmann::ordered_json units_json(const Config& config);
nlohmann::ordered_json cost_json(const Cost& cost);
nlohmann::ordered_json ranges_json(const Ranges& ranges);
nlohmann::ordered_json outcome_json(const Outcome& outcome);

}   // namespace rayclock::fit
