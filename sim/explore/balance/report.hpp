#pragma once
// A search for the fastest machine as text and JSON; every key is explained in docs/report.md.
#include <nlohmann/json.hpp>

#include "sim/explore/balance/search.hpp"

namespace rayclock::balance {

/// "contexts 16 -> 32, box_queue 16 -> 32".
std::string steps_text(const std::vector<Step>& steps);

/// What of a device it takes too much: "170 of 156 multipliers"; empty if it fits.
std::string excess(const chip::Use& use, const chip::Use& room);

/// The way that the search went, and what one step more would bring and cost.
std::string text(const Found& found, const chip::Use& room);
nlohmann::ordered_json json(const Found& found, const chip::Use& room);

}   // namespace rayclock::balance
