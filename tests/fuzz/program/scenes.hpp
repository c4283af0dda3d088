// What must hold of a scene that a reader has let pass.
#pragma once
#include <functional>
#include <string_view>

#include "sim/load/loading.hpp"

namespace rayclock::fuzz {

/// Small files may ask for a million times their size. So that an input takes a fraction of a second, they
/// get less here; tests/load/hostile_test.cpp tries the full allowance, and RC_FUZZ_LARGE has it as well.
constexpr Allowance small_allowance{std::uint64_t{1} << 20, 256};

enum class Finite {
    always,   ///< coordinates are 32-bit floats as they stand in the file
    checked   ///< they were transformed; check_scene() refuses the rest
};

/// Reads; of every eighth length once more, which must give the same. What passes must have its indices in
/// range, whatever check_scene() says, and once that has passed it, it can be lit and seen.
void check_reader(std::string_view bytes, const std::function<Scene(Loading&)>& read, Finite finite);

}   // namespace rayclock::fuzz
