#pragma once
// The netlist that Yosys makes of a module for an ECP5, to be simulated in the place of the RTL.
#include <filesystem>
#include <string>

#include "model/core/config.hpp"
#include "sim/run/rtl/stage.hpp"

namespace rayclock {

/// `yosys -V`, or empty if there is none. Asked once.
const std::string& gates_tool();

/// Everything that goes into a netlist beside Yosys, as one text.
std::string gates_ingredients(const Config& config, const std::string& module);

/// Makes netlist.v in an empty folder, which then holds nothing else: the module, with the ports it has in
/// the RTL, and the models of all cells. Units are synthesised each by itself, as `rayclock chip` does it,
/// and what wires them stays a module: so the links between them keep their names. The cells are those that
/// are placed and routed, but for the counters, which a routed chip goes without. Throws as build_rtl() does.
void make_gates(const std::filesystem::path& folder, const Config& config, const std::string& module,
                const Working& working);

/// What Verilator is told of a netlist: units are classes of their own, which keeps names short.
std::string gates_vlt();

}   // namespace rayclock
