#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

/// Makes the RTL of a configuration ready to run: generates rc_pkg.sv, calls Verilator and the C++ compiler, and keeps the
/// shared library in a cache under a hash of everything that went in. Two processes may build the same thing at once.
/// Warnings of Verilator (-Wall) are errors.
struct RtlBuild {
    std::filesystem::path library;
    bool was_cached = false;
    double seconds = 0;
};
/// `module` is rc_top or a unit (sim/rtl/adapter.hpp). Throws UserError if a tool is missing, std::runtime_error with the
/// tool's message if it fails.
RtlBuild build_rtl(const Config& config, const std::string& module = "rc_top");

/// What `verilator --lint-only -Wall` says of the module with this configuration: nothing if it is clean. Far quicker than to build it.
std::string lint_rtl(const Config& config, const std::string& module = "rc_top");

/// Where built libraries are kept: $RAYCLOCK_CACHE, or $XDG_CACHE_HOME/rayclock, or ~/.cache/rayclock.
std::filesystem::path rtl_cache();

/// Folder of the Verilog sources: $RAYCLOCK_RTL (to try out a changed copy), or those of this project.
std::filesystem::path rtl_sources();

/// All of them but the package, in a fixed order.
std::vector<std::filesystem::path> rtl_files();

} // namespace rayclock
