#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "model/core/config.hpp"
#include "sim/files/cache/libraries.hpp"
#include "sim/run/rtl/compile.hpp"
#include "sim/run/rtl/sources.hpp"

namespace rayclock {

/// Makes the RTL of a configuration ready to run: generates rc_pkg.sv, calls Verilator and the C++ compiler,
/// and keeps the shared library in a cache under a hash of everything that went in, the versions of both
/// tools among it. What the cache holds is checked by size and hash, and built again if it is damaged. Two
/// programs may build the same thing at once: one of them does. If this program dies, its tools die with it,
/// and what they have made is removed. Warnings of Verilator (-Wall) are errors.
struct RtlBuild {
    std::filesystem::path library;
    bool was_cached = false;
    double seconds = 0;
};
/// `module` is rc_chip or a unit (sim/run/rtl/adapter.hpp). Throws UserError if a tool, a source or the cache
/// is missing, std::runtime_error with the tool's message if it fails, or if interrupted().
RtlBuild build_rtl(const Config& config, const std::string& module = "rc_chip", Waves waves = Waves::no);

/// From now on this program builds netlists in the place of RTL (sim/run/rtl/gates.hpp). Throws UserError if
/// Yosys is missing.
void build_netlists();

/// Removes a library that is as it was built and yet of no use, so that it is built again.
void forget_rtl(const RtlBuild& build);

/// What `verilator --lint-only -Wall` says of the module with this configuration: nothing if it is clean. Far
/// quicker than to build it.
std::string lint_rtl(const Config& config, const std::string& module = "rc_chip");

/// How far a build is, for people who wait for it.
struct BuildStep {
    std::string what;             ///< "the RTL of 'default'"
    std::string stage;            ///< who works on it; empty: it is done
    double seconds = 0;           ///< since it was asked for
    std::optional<double> left;   ///< about so many more
};
/// Who is told of all builds of this program from now on, some ten times a second, by one thread at a time.
void report_builds(std::function<void(const BuildStep&)> reporter);

}   // namespace rayclock
