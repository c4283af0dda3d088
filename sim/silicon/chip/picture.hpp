#pragma once
// Where the cells of each unit lie on the device, as a drawing.
#include "sim/silicon/chip/route.hpp"
#include "sim/view/plot/drawing.hpp"

namespace rayclock::chip {

/// Every tile of the device that is in use: filled as far as its eight places of a LUT and a flip-flop are,
/// in the colours of the units; multipliers and block RAMs fill theirs. Units are listed beside it, the
/// largest first.
plot::Drawing placement(const Route& route, const Device& device, const std::string& title);

}   // namespace rayclock::chip
