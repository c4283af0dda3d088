#pragma once
// From Verilog to a shared library, in a folder of its own.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "model/core/config.hpp"
#include "sim/run/rtl/stage.hpp"

namespace rayclock {

/// Whether a library can write waveforms of its signals (sim/run/rtl/wave_abi.hpp). It is slower then, and
/// takes longer to build.
enum class Waves : bool { no, yes };

/// What is simulated: the RTL as it is written, or the netlist that Yosys makes of it
/// (sim/run/rtl/gates.hpp).
enum class Form : bool { rtl, netlist };

/// Everything that goes into a library beside the tools, as one text: whatever changes it changes the
/// library.
std::string ingredients(const Config& config, const std::string& module, Waves waves, Form form);

/// Verilator's own sources, which all modules need, to write waveforms or not: what goes into them, and how
/// they are compiled, in an empty folder.
std::string support_ingredients(Waves waves);
void make_support(const std::filesystem::path& folder, Waves waves, const Working& working);

/// Makes module.so in an empty folder, which then holds nothing else. `support` is what make_support() has
/// made, `netlist` what make_gates() has made, or empty for the RTL. Throws as build_rtl() does.
void make_library(const std::filesystem::path& folder, const Config& config, const std::string& module,
                  Waves waves, const std::filesystem::path& support, const std::filesystem::path& netlist,
                  const Working& working);

/// Verilator's opinion of the module, made in an empty folder.
std::string lint_library(const std::filesystem::path& folder, const Config& config,
                         const std::string& module);

}   // namespace rayclock
