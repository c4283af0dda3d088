#pragma once
// The Verilog line that drives a differing link.
#include <string>
#include <vector>

#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// A line of the Verilog sources.
struct SourceLine {
    std::string file;   ///< from the folder of the sources: "unit/isect/rc_tri.sv"
    std::size_t line = 0;
    std::string text;
};
/// What differs at the unit's end of a divergence's link, under the names that its port may have.
std::vector<std::string> output_names(const Divergence& divergence, const Config& config);

/// Where the unit of a divergence drives what differs: the payload, the offer, or its acceptance. If no line
/// does, the line that begins its module; an empty file if there is no module of that name.
SourceLine source_of(const Divergence& divergence, const Config& config);

}   // namespace rayclock
