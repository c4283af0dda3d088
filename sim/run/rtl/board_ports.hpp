#pragma once
// The ports of the modules of rtl/board that are simulated alone.
#include <string>
#include <vector>

#include "sim/run/rtl/adapter.hpp"
#include "sim/run/rtl/sources.hpp"

namespace rayclock {

/// Returns the ports of a module of rtl/board, which is named without parameters. Returns nothing for any
/// other module. Clocks and resets besides clk_i and rst_ni are ports that the user drives. A port that
/// exists in both directions is called <name> as an input and <name>_out as an output.
std::vector<PortSpec> board_ports(const std::string& module);

/// Returns the sources that a module needs, which may be named with parameters.
inline RtlScope scope_of(const std::string& module) {
    return board_ports(module_name(module)).empty() ? RtlScope::chip : RtlScope::board;
}

}   // namespace rayclock
