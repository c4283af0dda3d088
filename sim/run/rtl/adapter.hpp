#pragma once
// The generated source that connects a verilated module to sim/run/rtl/abi.hpp.
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

/// The ports of a link in Verilog.
enum class PortKind {
    in,        ///< <name>_valid_i, <name>_ready_o, <name>_i
    out,       ///< <name>_valid_o, <name>_ready_i, <name>_o
    fixed,     ///< <name>_i alone; or <data>_i if an output has that name already
    listen,    ///< <name>_fires_i, <name>_i: always accepted
    granted,   ///< <name>_ready_o, <name>_fires_i, <name>_i: sent only if there is room
    fires,     ///< <name>_fires_o, <name>_o: always accepted by the receiver
    plain,     ///< <name>_o alone: a plain output; or <data>_o if an input has that name already
    tap,       ///< signals of an inner instance; see PortSpec
};
/// A link of a module.
struct PortSpec {
    std::string name;
    PortKind kind;
    /// For a tap: the instance's path under the top, its module, and the names of its signals. An empty name
    /// means that there is no such signal.
    std::string path{}, module{}, valid{}, ready{}, data{};
};

/// A module may be given with values of its parameters: "rc_host_link Baud=115200". Returns its name alone.
std::string module_name(const std::string& module);
/// Returns the values: {"Baud=115200"}.
std::vector<std::string> module_parameters(const std::string& module);

/// Returns the links of a module that can be built on its own: rc_chip or a unit. Those of rc_chip include
/// every link of pipeline p as "<link>[p]". Throws std::logic_error for any other name.
std::vector<PortSpec> ports_of(const std::string& module, const Config& config);

/// Return the C++ text of the library's side of sim/run/rtl/abi.hpp, and the Verilator configuration that
/// makes the taps visible.
std::string adapter_source(const std::string& module, const Config& config);
std::string adapter_vlt(const std::string& module, const Config& config);

/// Returns the C++ text of the library's side of sim/run/rtl/wave_abi.hpp, which must follow
/// adapter_source().
std::string wave_source();

}   // namespace rayclock
