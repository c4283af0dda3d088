#pragma once
// The torture cases of one chip: combinations of images, frames and disturbances.
#include "sim/explore/torture/torture.hpp"

namespace rayclock::torture {

std::vector<TortureCase> cases_of(const Config& config);

}   // namespace rayclock::torture
