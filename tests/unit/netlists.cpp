// RAYCLOCK_TEST_NETLISTS=1: what these tests say of the RTL they say of the netlists that Yosys makes of it.
#include <cstdlib>

#include "sim/run/rtl/builder.hpp"

namespace {

[[maybe_unused]] const bool asked = [] {
    const char* const set = std::getenv("RAYCLOCK_TEST_NETLISTS");
    if (set && *set) rayclock::build_netlists();
    return true;
}();

}   // namespace
