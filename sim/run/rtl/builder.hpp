#pragma once
// Building the RTL of any configuration on demand.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "model/core/config.hpp"
#include "sim/files/cache/libraries.hpp"
#include "sim/run/rtl/compile.hpp"
#include "sim/run/rtl/sources.hpp"

namespace rayclock {

/// A built library. build_rtl() generates rc_pkg.sv and calls Verilator and the C++ compiler. It keeps the
/// shared library in a cache, under a hash of all inputs and of the versions of both tools. It checks cached
/// libraries by size and hash, and rebuilds a damaged one. If two programs need the same library at once, one
/// of them builds it. If this program dies, its tools die with it and their files are removed. Warnings of
/// Verilator (-Wall) are errors.
struct RtlBuild {
    std::filesystem::path library;
    bool was_cached = false;
    double seconds = 0;
};
/// Builds or finds a library. `module` is rc_chip or a unit (sim/run/rtl/adapter.hpp). Throws UserError if a
/// tool, a source or the cache is missing, or if a tool fails (with its message). Throws std::runtime_error
/// if Verilator warns, and Interrupted after Ctrl-C.
RtlBuild build_rtl(const Config& config, const std::string& module = "rc_chip", Waves waves = Waves::no);

/// Makes this program build netlists instead of RTL from now on (sim/run/rtl/gates.hpp). Throws UserError if
/// Yosys is missing.
void build_netlists();

/// Removes a library that is undamaged but cannot be used, so that it is built again.
void forget_rtl(const RtlBuild& build);

/// Returns the messages of `verilator --lint-only -Wall` on the module with this configuration; empty if it
/// is clean. Much faster than a build. Throws UserError if Verilator is missing.
std::string lint_rtl(const Config& config, const std::string& module = "rc_chip");

/// The progress of a build, for display.
struct BuildStep {
    std::string what;             ///< "the RTL of 'default'"
    std::string stage;            ///< the tool that works on it; empty: the build has ended
    double seconds = 0;           ///< since it was requested
    std::optional<double> left;   ///< estimated seconds until the end
};
/// Sets the function that receives the progress of all builds of this program. It is called about ten times a
/// second, by one thread at a time.
void report_builds(std::function<void(const BuildStep&)> reporter);

}   // namespace rayclock
