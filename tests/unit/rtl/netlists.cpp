// RAYCLOCK_TEST_NETLISTS=1: these tests check Yosys's netlists instead of the RTL.
#include <cstdlib>

#include "sim/run/rtl/builder.hpp"

namespace {

[[maybe_unused]] const bool are_built = [] {
    const char* const set = std::getenv("RAYCLOCK_TEST_NETLISTS");
    if (set && *set) rayclock::build_netlists();
    return true;
}();

}   // namespace
