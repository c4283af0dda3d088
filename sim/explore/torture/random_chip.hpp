#pragma once
// Random legal chips: for tests, and for the command stress with a stream of rays.
#include <cstdint>

#include "model/core/config.hpp"

namespace rayclock {

/// Draws a legal configuration. About half of its values are at an end of their range. `single` draws one
/// that does not shade, with one pipeline. Otherwise it has one pipeline, or in one of four cases two. In one
/// of three cases it has a shared cache. In half of the cases where two levels are possible it has two, with
/// any two structures.
Config random_chip(std::uint64_t seed, bool single);

}   // namespace rayclock
