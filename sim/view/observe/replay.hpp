#pragma once
// Replays of recorded frames that observers watch.
#include <span>

#include "sim/run/frame/frame.hpp"
#include "sim/view/observe/costs.hpp"
#include "sim/view/observe/events.hpp"

namespace rayclock {

/// Replays frames on one machine as replay() does, with the same cycles, and observes the last frame. A
/// window has `window` cycles; 0 records no windows. `sink` may be null. The result is partial if
/// interrupted() is set or the sink is done before the frame ends.
FrameCosts observe(const Config& config, int khz, std::span<const RecordedFrame> frames,
                   Disturbance disturbance, std::uint64_t window, EventSink* sink,
                   const Progress& progress = {});

/// Replays one pixel of a recorded frame alone on the chip and observes its second pass, when the caches are
/// warm. The result shows what the pixel takes if it never waits for another ray.
FrameCosts observe_alone(const Config& config, int khz, const RecordedFrame& frame, std::uint32_t pixel,
                         EventSink* sink);

}   // namespace rayclock
