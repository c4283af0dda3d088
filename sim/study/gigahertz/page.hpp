#pragma once
#include "sim/study/gigahertz/measure.hpp"
#include "sim/view/plot/drawing.hpp"

namespace rayclock::gigahertz {

/// The page in Markdown. `command` is what was typed, `picture` the name of picture()'s file without ending.
std::string page(const Figures& figures, const Study& study, const std::string& command,
                 const std::string& picture);

/// Frames per second against the clock, a line for each memory: with the fewest and the most pipelines.
plot::Drawing picture(const Figures& figures, const Study& study);

}   // namespace rayclock::gigahertz
