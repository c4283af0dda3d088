#pragma once
// The programs that the RTL needs: which are there, and which of their versions were tried with this one.
#include <string>
#include <vector>

namespace rayclock {

/// First line of what a program says of its version, or empty if it is not there or does not run.
std::string version_line(const std::vector<std::string>& words);

/// What turns Verilog into a library.
struct RtlTools {
    std::string verilator, compiler;   ///< version lines
    std::string verilator_root;        ///< folder of Verilator's own sources
    std::string problem;               ///< what is missing, in a sentence; empty if nothing is
};
/// Asked once.
const RtlTools& rtl_tools();

/// A tool and the versions of it that rayclock was tried with, as Debian 12 and 13 have them.
struct TriedTool {
    const char* name;
    std::vector<std::string> versions;
};
const std::vector<TriedTool>& tried_tools();

/// "5.006", "clang 14" or "12" (of GCC, the first number alone) from a version line of that tool; empty if
/// there is none in it.
std::string short_version(const std::string& tool, const std::string& line);

/// A sentence if this version was not tried; otherwise empty.
std::string untried(const std::string& tool, const std::string& line);

}   // namespace rayclock
