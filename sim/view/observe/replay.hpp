#pragma once
#include <span>

#include "sim/run/engine/engine.hpp"
#include "sim/view/observe/costs.hpp"
#include "sim/view/observe/events.hpp"

namespace rayclock {

/// Replays frames on one machine as replay() does, and watches the last one: its cycles are the same.
/// `window` cycles are a window, 0: none are wanted; `sink` may be null. Partial when interrupted(), or
/// when the sink is done before the frame.
FrameCosts observe(const Config& config, int khz, std::span<const FrameTrace> frames, Traffic traffic,
                   std::uint64_t window, EventSink* sink, const Progress& progress = {});

/// One pixel of a recorded frame alone on the chip, a second time, when its lines lie in the caches as far as
/// they fit: what it takes if it never waits for another ray.
FrameCosts observe_alone(const Config& config, int khz, const FrameTrace& frame, std::uint32_t pixel,
                         EventSink* sink);

}   // namespace rayclock
