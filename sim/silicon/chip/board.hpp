#pragma once
// The whole board as the content of an FPGA: its top, its pins, and the bitstream of the routed design.
#include <filesystem>
#include <string>

#include "model/core/config.hpp"

namespace rayclock::chip {

/// The name of the board among the designs to route, where a unit or "chip" can stand.
constexpr const char* board_top = "board";

/// Throws UserError if the board's PLL cannot make this clock, in kHz, from 25 MHz: rc_ulx3s.v has 75 and
/// 62.5 MHz.
void check_pll(int khz);

/// Returns the content of rtl/ecp5/rc_ulx3s.v. Throws UserError if it cannot be read.
std::string board_verilog();

/// Returns the pins and the frequency of the board's oscillator, rtl/ecp5/ulx3s.lpf. Throws UserError if it
/// cannot be read.
std::string board_pins();

/// Returns the parameters of the top for Yosys' command `hierarchy`. The bitstream contains the hash of the
/// configuration, which the host compares (sim/board/identity.hpp).
std::string board_parameters(const Config& config, int khz);

/// Makes a bitstream of a textual configuration written by nextpnr. Both names are relative to the folder.
/// Throws UserError if ecppack is missing or fails, and Interrupted after Ctrl-C.
void pack_bitstream(const std::filesystem::path& folder, const char* textual, const char* bitstream);

/// Returns the version of ecppack for keys of results. Throws UserError if it is not installed.
const std::string& packer_version();

}   // namespace rayclock::chip
