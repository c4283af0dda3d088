#pragma once
// A pixel's story as one HTML file: the paths of its rays through the tree, as pictures.
#include "sim/view/explain/explain.hpp"

namespace rayclock {

/// `json` is what explain writes, `text` what it prints with all steps. Throws UserError if the library that
/// draws the charts is not installed.
std::string explanation_page(const nlohmann::ordered_json& json, const std::string& text,
                             const Explanation& e,
                             const std::vector<std::pair<std::string, std::string>>& origin);

}   // namespace rayclock
