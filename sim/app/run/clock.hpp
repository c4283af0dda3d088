#pragma once
// Clocks of machines: typed by the user, or those of a routed chip.
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/core/config.hpp"

namespace rayclock {

/// Parses "66,fmax" like parse_clocks(), where fmax is the clock at which `rayclock chip` routed this
/// configuration. Throws UserError if it was not routed, or if the memory dram=board does not allow a clock.
std::vector<int> clocks_of(const std::string& typed, const Config& config);

/// Refuses what clocks_of() would refuse for every configuration, before a scene is loaded. Throws UserError.
void check_clocks(const std::string& typed);

/// Does the same for a command that takes one clock. Throws UserError if several are given.
int one_clock_of(const std::string& typed, const Config& config);

/// Returns "routed" if a routed chip is at least this fast, otherwise "assumed".
std::string clock_is(const Config& config, int khz);

/// Adds clock_is and clock_mhz_routed to the output of clock_json().
void mark_clock(nlohmann::ordered_json& clock, const Config& config, int khz);

/// Returns a line of text about these clocks.
std::string clock_line(const Config& config, const std::vector<int>& khz);

}   // namespace rayclock
