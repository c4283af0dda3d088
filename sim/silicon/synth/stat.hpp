#pragma once
// Reads the output of Yosys's `stat` as JSON.
#include <string>

#include "sim/silicon/synth/netlist.hpp"

namespace rayclock::synth {

/// Reads the counts of a whole design from `stat -width -json`. Throws UserError if the format is wrong.
Netlist counts_of(const std::string& stat);

}   // namespace rayclock::synth
