#pragma once
#include "sim/explore/stress/run.hpp"

namespace rayclock::stress {

/// docs/hard-cases.md: the families with their pictures, which go into a folder beside the page, and what
/// came of the run. Throws UserError if a file cannot be written.
void write_page(const std::string& path, const Plan& plan, const Outcome& outcome);

}   // namespace rayclock::stress
