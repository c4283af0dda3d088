#pragma once
// The Verilog line that drives a differing link.
#include <string>
#include <vector>

#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// A line of the Verilog sources.
struct SourceLine {
    std::string file;   ///< path in the folder of the sources: "unit/tri/rc_tri.sv"
    std::size_t line = 0;
    std::string text;
};
/// Returns the possible names of the differing signal at the unit's end of a divergence's link.
std::vector<std::string> output_names(const Divergence& divergence, const Config& config);

/// Returns the line where the unit of a divergence drives the differing signal: payload, valid or ready. If
/// no line drives it, returns the first line of its module. The file is empty if there is no such module.
SourceLine source_of(const Divergence& divergence, const Config& config);

}   // namespace rayclock
