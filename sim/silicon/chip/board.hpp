#pragma once
// The whole board as the content of an FPGA: its top, its pins, and the bitstream of the routed design.
#include <filesystem>
#include <string>

#include "model/core/config.hpp"

namespace rayclock::chip {

/// The value of Request::top for the board, instead of "chip" or the name of a unit.
constexpr const char* board_top = "board";

/// Throws UserError if rc_ulx3s.v has no settings of the PLL for this clock, in kHz. It has settings for 75
/// and 62.5 MHz.
void check_pll(int khz);

/// Returns the content of rtl/ecp5/rc_ulx3s.v. Throws UserError if it cannot be read.
std::string board_verilog();

/// Returns the pin assignments and the oscillator's frequency, rtl/ecp5/ulx3s.lpf. Throws UserError if it
/// cannot be read.
std::string board_pins();

/// Returns the parameters of the top for Yosys' command `hierarchy`: the clock, the SDRAM of the
/// configuration, and the hash. The bitstream contains the hash of the configuration, which the host compares
/// (sim/board/identity.hpp).
std::string board_parameters(const Config& config, int khz);

/// Returns commands of Yosys that place the registers at the SDRAM's pins in the pins' own cells. So the
/// times between registers and pins do not depend on the placement. They fail if a register is missing.
std::string pin_registers();

/// Makes a bitstream of a textual configuration written by nextpnr. Both names are relative to the folder.
/// Throws UserError if ecppack is missing or fails, and Interrupted after Ctrl-C.
void pack_bitstream(const std::filesystem::path& folder, const char* textual, const char* bitstream);

/// Returns the version of ecppack for cache keys. Throws UserError if it is not installed.
const std::string& packer_version();

}   // namespace rayclock::chip
