#pragma once
// Draws the position of each unit's cells on the device.
#include "sim/silicon/chip/route.hpp"
#include "sim/view/plot/drawing.hpp"

namespace rayclock::chip {

/// Returns the drawing. Each tile in use is filled in proportion to its eight LUTs and flip-flops, in the
/// colours of its units. Multipliers and block RAMs fill their tiles. The legend lists units, the largest
/// first.
plot::Drawing placement(const Route& route, const Device& device, const std::string& title);

}   // namespace rayclock::chip
