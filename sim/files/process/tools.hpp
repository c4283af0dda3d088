#pragma once
// The programs that the RTL needs: which are installed, and which versions were tried with rayclock.
#include <string>
#include <vector>

namespace rayclock {

/// Returns the first line that a program prints about its version. Returns an empty string if it does not
/// exist or fails.
std::string version_line(const std::vector<std::string>& words);

/// The tools that turn Verilog into a library.
struct RtlTools {
    std::string verilator, compiler;   ///< version lines
    std::string verilator_root;        ///< folder of Verilator's own sources
    std::string problem;               ///< a sentence that names what is missing; empty if nothing is
};
/// Returns the installed tools. Runs them at the first call only.
const RtlTools& rtl_tools();

/// A tool and the versions that rayclock was tried with, which are those of Debian 12 and 13.
struct TriedTool {
    const char* name;
    std::vector<std::string> versions;
};
const std::vector<TriedTool>& tried_tools();

/// Returns "5.006", "clang 14" or "12" from a version line of that tool. For GCC it is the first number
/// alone. Returns an empty string if the line holds no version.
std::string short_version(const std::string& tool, const std::string& line);

/// Returns a warning if this version was not tried, and an empty string otherwise.
std::string untried(const std::string& tool, const std::string& line);

}   // namespace rayclock
