#pragma once
// Compiling Verilog into a shared library, in a separate folder.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "model/core/config.hpp"
#include "sim/run/rtl/stage.hpp"

namespace rayclock {

/// Whether a library can write waveforms of its signals (sim/run/rtl/wave_abi.hpp). Such a library runs
/// slower and takes longer to build.
enum class Waves : bool { no, yes };

/// The simulated form: the RTL as written, or Yosys' netlist of it (sim/run/rtl/gates.hpp).
enum class Form : bool { rtl, netlist };

/// Returns all inputs of a library except the tools, as one text: any change of it means another library.
std::string build_inputs(const Config& config, const std::string& module, Waves waves, Form form);

/// Verilator's own sources, which all modules need, in a version with and one without waveforms. The function
/// support_inputs() returns their inputs, and make_support() compiles them in an empty folder.
std::string support_inputs(Waves waves);
void make_support(const std::filesystem::path& folder, Waves waves, const Working& working);

/// Makes module.so in an empty folder, and leaves nothing else in it. `support` is the result of
/// make_support(). `netlist` is that of make_gates(), or empty for the RTL. Throws as build_rtl() does.
void make_library(const std::filesystem::path& folder, const Config& config, const std::string& module,
                  Waves waves, const std::filesystem::path& support, const std::filesystem::path& netlist,
                  const Working& working);

/// Returns Verilator's messages about the module. Works in an empty folder.
std::string lint_library(const std::filesystem::path& folder, const Config& config,
                         const std::string& module);

}   // namespace rayclock
