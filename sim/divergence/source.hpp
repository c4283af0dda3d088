#pragma once
#include <string>

#include "sim/lockstep/lockstep.hpp"

namespace rayclock {

/// A line of the Verilog sources.
struct SourceLine {
    std::string file;   ///< from the folder of the sources: "isect/rc_tri.sv"
    std::size_t line = 0;
    std::string text;
};
/// Where the unit of a divergence drives what differs: the payload, the offer, or its acceptance. If no line
/// does, the line that begins its module; an empty file if there is no module of that name.
SourceLine source_of(const Divergence& divergence);

}   // namespace rayclock
