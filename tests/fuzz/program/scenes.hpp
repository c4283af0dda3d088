#pragma once
// Requirements on a scene that a reader accepts.
#include <functional>
#include <string_view>

#include "sim/load/loading.hpp"

namespace rayclock::fuzz {

/// Small files may request a million times their size. The allowance is smaller here, so that an input takes
/// a fraction of a second. tests/load/faulty/proportional_cost_test.cpp tests the full allowance, and
/// RC_FUZZ_LARGE also has it.
constexpr Allowance small_allowance{std::uint64_t{1} << 20, 256};

enum class Finite {
    always,   ///< coordinates are the 32-bit floats of the file
    checked   ///< coordinates were transformed; check_scene() refuses infinite ones
};

/// Reads the bytes. One in eight lengths is read twice and must give the same result. An accepted scene must
/// have valid indices, whatever check_scene() says. After check_scene() accepts it, it can be lit and seen.
void check_reader(std::string_view bytes, const std::function<Scene(Loading&)>& read, Finite finite);

}   // namespace rayclock::fuzz
