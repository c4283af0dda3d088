#pragma once
// The page of hard cases.
#include "sim/explore/stress/stress_batches.hpp"

namespace rayclock::stress {

/// Writes docs/measured/hard-cases.md: the families, their pictures in a folder next to the page, and the
/// results of the run. Throws UserError if a file cannot be written.
void write_page(const std::string& path, const Plan& plan, const StressResult& outcome);

}   // namespace rayclock::stress
