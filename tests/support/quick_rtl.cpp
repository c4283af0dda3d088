// RTL that tests build runs for less time than it takes to compile, so it is compiled with -O1, unless
// whoever runs the tests has chosen otherwise. What people run is compiled with -O2.
#include <cstdlib>

namespace {

[[maybe_unused]] const int chosen = setenv("RAYCLOCK_CXXFLAGS", "-O1", 0);

}   // namespace
