#pragma once
// The explanation of one pixel as an HTML file, with a drawing of each ray's path through the tree.
#include "sim/view/explain/explain.hpp"

namespace rayclock {

/// Returns the page. `json` is the output of explain --json, `text` its output with all steps. Throws
/// UserError if the chart library is not installed.
std::string explanation_page(const nlohmann::ordered_json& json, const std::string& text,
                             const Explanation& e,
                             const std::vector<std::pair<std::string, std::string>>& origin);

}   // namespace rayclock
