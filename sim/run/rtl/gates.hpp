#pragma once
// Yosys' netlist of a module for an ECP5, which is simulated instead of the RTL.
#include <filesystem>
#include <string>

#include "model/core/config.hpp"
#include "sim/run/rtl/stage.hpp"

namespace rayclock {

/// Returns the output of `yosys -V`, or an empty string if Yosys is missing. Runs it at the first call only.
const std::string& gates_tool();

/// Returns all inputs of a netlist except Yosys, as one text.
std::string gates_inputs(const Config& config, const std::string& module);

/// Makes netlist.v in an empty folder, and leaves nothing else in it. It holds the module, with the same
/// ports as in the RTL, and the models of all cells. Each unit is synthesised by itself, as `rayclock chip`
/// does. The modules that only wire units stay modules, so the links between them keep their names. The cells
/// are those that are placed and routed, and also the counters, which a routed chip lacks. Throws as
/// build_rtl() does.
void make_gates(const std::filesystem::path& folder, const Config& config, const std::string& module,
                const Working& working);

/// Returns Verilator's configuration for a netlist: units become separate classes, which keeps names short.
std::string gates_vlt();

}   // namespace rayclock
