#pragma once
// docs/area.md, and the same figures as a table and as JSON.
#include "sim/silicon/area/run.hpp"
#include "sim/silicon/area/speed.hpp"

namespace rayclock::area {

/// Every unit of every variant, as a table for people.
std::string table(const Areas& areas);
nlohmann::ordered_json json(const Areas& areas, const std::vector<Speed>& speeds);

/// How fast three of the variants are simulated: without and with shading, and with all units. Throws
/// UserError.
std::vector<Speed> page_speeds(const Areas& areas, const Progress& progress);

/// As Markdown. `command` is what to type for it, `base` the configuration's name; `speeds` are those of
/// page_speeds().
std::string page(const Areas& areas, const std::vector<Speed>& speeds, const std::string& base,
                 const std::string& command);

}   // namespace rayclock::area
