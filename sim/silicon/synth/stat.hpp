#pragma once
// What Yosys counts: its `stat` as JSON.
#include <string>

#include "sim/silicon/synth/netlist.hpp"

namespace rayclock::synth {

/// What `stat -width -json` says of a whole design. Throws UserError if it is not that.
Netlist counts_of(const std::string& stat);

}   // namespace rayclock::synth
