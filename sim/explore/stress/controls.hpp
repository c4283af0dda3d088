#pragma once
// Negative controls: the exact test with one fault each. A judge must detect every one.
#include "sim/explore/stress/stress_batches.hpp"

namespace rayclock::stress {

/// Shrinks every child box of every node by one plane on each side where it has room. This imitates inward
/// rounding.
void shrink_boxes(MemoryImage& image, const Config& config);

const std::vector<NamedTest>& controls();

}   // namespace rayclock::stress
