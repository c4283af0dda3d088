// Compiles the RTL of tests with -Og unless RAYCLOCK_CXXFLAGS is set, because it runs for less time than it
// takes to compile. Users' RTL is compiled with -O2.
#include <cstdlib>

namespace {

[[maybe_unused]] const int chosen = setenv("RAYCLOCK_CXXFLAGS", "-Og", 0);

}   // namespace
