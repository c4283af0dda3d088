#pragma once
// The cases of one chip: which images, frames and disturbances meet.
#include "sim/explore/torture/torture.hpp"

namespace rayclock::torture {

std::vector<TortureCase> cases_of(const Config& config);

}   // namespace rayclock::torture
