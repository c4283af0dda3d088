#pragma once
#include <string>

namespace rayclock::test {

/// The program of this build, or the one that RAYCLOCK_PROGRAM names: mutants are judged by the same tests.
std::string program_under_test();

}   // namespace rayclock::test
