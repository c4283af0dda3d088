#pragma once
// The page docs/measured/area.md, and the same data as a table and as JSON.
#include "sim/silicon/area/synthesise_units.hpp"
#include "sim/silicon/area/speed.hpp"

namespace rayclock::area {

/// Returns every unit of every variant as a text table.
std::string table(const Areas& areas);
nlohmann::ordered_json json(const Areas& areas, const std::vector<Speed>& speeds);

/// Measures the simulation speed of three variants: without shading, with it, and with all units. Throws like
/// measure().
std::vector<Speed> page_speeds(const Areas& areas, const Progress& progress);

/// Returns the page as Markdown. `command` is the command that makes it, `base` the configuration's name,
/// `speeds` the result of page_speeds().
std::string page(const Areas& areas, const std::vector<Speed>& speeds, const std::string& base,
                 const std::string& command);

}   // namespace rayclock::area
