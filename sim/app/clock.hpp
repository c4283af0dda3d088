#pragma once
// Clocks of machines: typed, or those that a routed chip has shown.
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/core/config.hpp"

namespace rayclock {

/// "66,fmax": as parse_clocks(), and fmax is the clock that `rayclock chip` has routed this configuration
/// for. Throws UserError if it has not.
std::vector<int> clocks_of(const std::string& typed, const Config& config);

/// The same of a command that takes one. Throws UserError if several are given.
int one_clock_of(const std::string& typed, const Config& config);

/// Whether the clock was shown: "routed" if a routed chip is as fast, otherwise "assumed".
std::string clock_is(const Config& config, int khz);

/// Adds clock_is and clock_mhz_routed to what clock_json() gives.
void mark_clock(nlohmann::ordered_json& clock, const Config& config, int khz);

/// A line about these clocks for people.
std::string clock_line(const Config& config, const std::vector<int>& khz);

}   // namespace rayclock
