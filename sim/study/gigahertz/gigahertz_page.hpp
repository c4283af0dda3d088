#pragma once
// The text and the picture of the page gigahertz.
#include "sim/study/gigahertz/measure_gigahertz.hpp"
#include "sim/view/plot/drawing.hpp"

namespace rayclock::gigahertz {

/// Returns the page as Markdown. `command` is the command that makes it, `picture` the name of picture()'s
/// file without extension.
std::string page(const Figures& figures, const Study& study, const std::string& command,
                 const std::string& picture);

/// Draws frames per second against the clock, with a line for each memory: with the fewest and with the most
/// pipelines.
plot::Drawing picture(const Figures& figures, const Study& study);

}   // namespace rayclock::gigahertz
