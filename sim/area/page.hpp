#pragma once
// docs/area.md, and the same figures as a table and as JSON.
#include "sim/area/run.hpp"
#include "sim/area/speed.hpp"

namespace rayclock::area {

struct SpeedFrame {
    std::string scene, size;   ///< that speed was measured on
    int depth = 0;
};

/// Every unit of every variant, as a table for people.
std::string table(const Areas& areas);
nlohmann::ordered_json json(const Areas& areas, const std::vector<Speed>& speeds);
/// As Markdown. `command` is what to type for it, `base` the configuration's name.
std::string page(const Areas& areas, const std::vector<Speed>& speeds, const SpeedFrame& frame, const std::string& base, const std::string& command);

} // namespace rayclock::area
