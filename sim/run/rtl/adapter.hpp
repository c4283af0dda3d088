#pragma once
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

/// How a link of a module looks in Verilog.
enum class PortKind {
    in,        ///< <name>_valid_i, <name>_ready_o, <name>_i
    out,       ///< <name>_valid_o, <name>_ready_i, <name>_o
    fixed,     ///< <name>_i alone
    listen,    ///< <name>_fires_i, <name>_i: always accepted
    granted,   ///< <name>_ready_o, <name>_fires_i, <name>_i: comes only where there is room
    fires,     ///< <name>_fires_o, <name>_o: always accepted by others
    plain,     ///< <name>_o alone: what the module does; or <data>_o, if an input has that name already
    tap,       ///< signals of an instance inside; see PortSpec
};
struct PortSpec {
    std::string name;
    PortKind kind;
    /// Of a tap: the instance's path under the top, its module, and the names of its signals; empty: there is
    /// none.
    std::string path{}, module{}, valid{}, ready{}, data{};
};

/// The links of a module that can be built on its own: rc_chip or a unit. Throws std::logic_error for any
/// other name. Of rc_chip they include every link of pipeline p as "<link>[p]".
std::vector<PortSpec> ports_of(const std::string& module, const Config& config);

/// C++ text of the library's side of sim/run/rtl/abi.hpp, and the Verilator configuration that makes the taps
/// visible.
std::string adapter_source(const std::string& module, const Config& config);
std::string adapter_vlt(const std::string& module, const Config& config);

/// C++ text of the library's side of sim/run/rtl/wave_abi.hpp, to stand after adapter_source().
std::string wave_source();

}   // namespace rayclock
