#pragma once
// The program that the tests of cli run.
#include <string>

namespace rayclock::test {

/// Returns the program of this build, or the one that RAYCLOCK_PROGRAM names, so that the same tests judge
/// mutants.
std::string program_under_test();

}   // namespace rayclock::test
