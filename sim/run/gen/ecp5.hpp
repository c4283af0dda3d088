#pragma once
// How modules become cells of an ECP5: for areas, for routed chips and for netlists that are simulated.
#include <string>

namespace rayclock {

/// Yosys' commands once the hierarchy stands: `synth_ecp5 -nowidelut` to its end, or up to its step `until`,
/// and with flip-flops that share their resets.
///
/// synth_ecp5 of Yosys 0.23 gives each flip-flop whose reset is active low, or waits for the enable, an
/// inverter or gate of its own before that reset, and merges none of them. A tile of an ECP5 has eight
/// flip-flops and two wires for resets (Lattice, ECP5 family data sheet, FPGA-DS-02012, PFU), so that those
/// flip-flops fill two in a tile. And a reset of few flip-flops is cheaper as logic before their inputs.
std::string ecp5_steps(const std::string& until = {});

}   // namespace rayclock
