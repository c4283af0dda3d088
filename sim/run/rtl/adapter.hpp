#pragma once
// The generated source that connects a verilated module to sim/run/rtl/abi.hpp.
#include <string>
#include <utility>
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
    low,       ///< <name>_no alone: a plain output that is active low
    low_in,    ///< <name>_ni alone: an input that is active low
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

/// A module may be named with values of its parameters: "rc_sdram ClkKhz=75000 Cl=2". These functions return
/// the name alone, and the parameters with their values.
std::string module_name(const std::string& module);
std::vector<std::pair<std::string, std::string>> parameter_values(const std::string& module);

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
