#pragma once
// The result of a search for the fastest machine, as text and as JSON. docs/guide/report.md explains every
// key.
#include <nlohmann/json.hpp>

#include "sim/explore/balance/search.hpp"

namespace rayclock::balance {

/// Returns steps as text: "contexts 16 -> 32, box_queue 16 -> 32".
std::string steps_text(const std::vector<Step>& steps);

/// Returns the resources that exceed a device: "170 of 156 multipliers"; empty if the machine fits.
std::string excess(const chip::Use& use, const chip::Use& room);

/// Returns the path of the search, and the gain and cost of each further step.
std::string text(const SearchResult& found, const chip::Use& room);
nlohmann::ordered_json json(const SearchResult& found, const chip::Use& room);

}   // namespace rayclock::balance
