#pragma once
// Reads Verilog sources just well enough to find the driver of a signal. Expects the style of this project's
// RTL: one module in a file, instances called u_..., generate blocks called gen_...
#include <cstddef>
#include <string>
#include <vector>

namespace rayclock {

/// A statement, or a port of an instance, that drives signals.
struct SignalDriver {
    enum class Construct { combinational, registered, instance };
    Construct construct{};
    std::size_t line = 0;                 ///< from 1
    std::vector<std::string> targets;     ///< names that it drives
    std::vector<std::string> sources;     ///< names of the signals that it reads
    std::string instance, module, port;   ///< for Construct::instance: "u_hitdiv", "rc_hitdiv", "v_o"
};

/// A connection of an instance's input.
struct InputConnection {
    std::string instance, port;
    std::size_t line = 0;
    std::vector<std::string> sources;
};

struct ModuleText {
    std::string file, name;           ///< "unit/tri/rc_tri.sv", "rc_tri"
    std::vector<std::string> lines;   ///< unchanged
    std::vector<SignalDriver> drivers;
    std::vector<InputConnection> inputs;
};

/// Returns the module of a source; its name is empty if there is none.
ModuleText read_module(const std::string& file, const std::string& text);

}   // namespace rayclock
