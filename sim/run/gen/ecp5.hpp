#pragma once
// Synthesis for ECP5: the same steps serve areas, routed chips and simulated netlists.
#include <string>

namespace rayclock {

/// Returns Yosys' commands after `hierarchy`: `synth_ecp5 -nowidelut` to its end, or up to its step `until`,
/// and with flip-flops that share their resets.
///
/// synth_ecp5 of Yosys 0.23 puts a separate inverter or gate before the reset of each flip-flop whose reset
/// is active low or waits for the enable. It merges none of them. A tile of an ECP5 has eight flip-flops and
/// two wires for resets (Lattice, ECP5 family data sheet, FPGA-DS-02012, PFU). So two of those flip-flops
/// fill a tile. A reset of few flip-flops is cheaper as logic before their inputs.
std::string ecp5_steps(const std::string& until = {});

}   // namespace rayclock
