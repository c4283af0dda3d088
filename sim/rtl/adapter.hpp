#pragma once
#include <string>
#include <vector>

namespace rayclock {

/// How a link of a module looks in Verilog.
enum class PortKind {
    in,      ///< <name>_valid_i, <name>_ready_o, <name>_i
    out,     ///< <name>_valid_o, <name>_ready_i, <name>_o
    fixed,   ///< <name>_i alone, set before reset is released
    listen,  ///< <name>_fires_i, <name>_i: seen, not answered
    tap,     ///< a link between units inside: <name>_valid, <name>_ready, <name>
};
struct PortSpec {
    std::string name;
    PortKind kind;
};

/// The links of a module that can be built on its own: rc_top or a unit. Throws std::logic_error for any other name.
std::vector<PortSpec> ports_of(const std::string& module);

/// C++ text of the library's side of sim/rtl/abi.hpp, and the Verilator configuration that makes the taps visible.
std::string adapter_source(const std::string& module);
std::string adapter_vlt(const std::string& module);

} // namespace rayclock
