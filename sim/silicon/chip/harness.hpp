#pragma once
// A module with four pins around one with hundreds, so that it can be placed alone: the package has 205 pads.
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock::chip {

/// A port, as Yosys sees it once the parameters are known.
struct Port {
    std::string name;
    bool is_input = false;
    std::uint64_t width = 0;
};

/// What Yosys finds when it only reads a module and its hierarchy.
struct Face {
    std::vector<Port> ports;
    std::vector<std::string> modules;   ///< beneath it and itself, without rc_, in alphabetical order
};
/// From what write_json says of blackboxes. Throws UserError if it is not that.
Face face_of(const std::string& netlist, const std::string& top);

/// The harness: a shift register feeds all inputs. All outputs go into registers, and from there into a shift
/// register that sums them up, so that no logic but one XOR of the harness lies between two of its own
/// registers and none between them and the unit's ports. It holds an instance `u_TOP` of rc_TOP.
std::string harness_text(const Config& config, const std::string& top, const Face& face);

}   // namespace rayclock::chip
