#pragma once
// Negative controls: the exact test with a fault each. Whoever judges must notice every one.
#include "sim/explore/stress/run.hpp"

namespace rayclock::stress {

/// Makes every child box of every node smaller by one plane on each side where it has the room: rounding
/// inwards.
void shrink_boxes(MemoryImage& image, const Config& config);

const std::vector<NamedTest>& controls();

}   // namespace rayclock::stress
