#pragma once
// A module with four pins around a module with hundreds, so that it can be placed alone. The package has 205
// pads.
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock::chip {

/// A port with its width after elaboration.
struct Port {
    std::string name;
    bool is_input = false;
    std::uint64_t width = 0;
};

/// The interface and the modules of a top module, from Yosys's elaboration.
struct ModuleInterface {
    std::vector<Port> ports;
    /// The top and all modules below it, without rc_, in alphabetical order.
    std::vector<std::string> modules;
};
/// Reads the output of Yosys's write_json for blackboxes. Throws UserError if the text has another format.
ModuleInterface interface_of(const std::string& netlist, const std::string& top);

/// Returns the harness, which holds an instance `u_TOP` of rc_TOP. A shift register drives all inputs.
/// Registers sample all outputs, and a second shift register sums them. So at most one XOR lies between two
/// registers of the harness, and no logic lies between them and the unit's ports.
std::string harness_text(const Config& config, const std::string& top, const ModuleInterface& interface);

}   // namespace rayclock::chip
