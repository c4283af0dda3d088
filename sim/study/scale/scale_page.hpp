#pragma once
// The text and the picture of the page scale.
#include <nlohmann/json.hpp>

#include "sim/study/scale/measure_scale.hpp"
#include "sim/view/plot/drawing.hpp"

namespace rayclock::scale {

/// Returns the page as Markdown. `command` is the command that makes the page. `picture` is the name of
/// picture()'s file without its extension.
std::string page(const Figures& figures, const Study& study, const std::string& command,
                 const std::string& picture);

/// Returns all rows and exponents as JSON: docs/guide/report.md.
nlohmann::ordered_json figures_json(const Figures& figures);

/// Draws seconds against triangles and against pixels, with a line for each kind of work.
plot::Drawing picture(const Figures& figures, const Study& study);

}   // namespace rayclock::scale
