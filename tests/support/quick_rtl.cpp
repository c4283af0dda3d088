// Sets the compiler's flags for the RTL of tests, unless RAYCLOCK_CXXFLAGS is set: -Og, and Verilator's
// header precompiled. Users' RTL is compiled with -O2.
#include <cstdlib>
#include <string>

namespace {

const std::string header = RAYCLOCK_RTL_HEADER;
[[maybe_unused]] const int chosen =
    setenv("RAYCLOCK_CXXFLAGS", (header.empty() ? "-Og" : "-Og -include " + header).c_str(), 0);

}   // namespace
