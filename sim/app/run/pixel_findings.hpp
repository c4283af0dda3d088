#pragma once
// Explanations of one pixel for explain, and of many pixels for simulate's report.
#include "sim/app/run/frame_comparison.hpp"
#include "sim/view/explain/explain.hpp"

namespace rayclock {

/// Returns the finding for a pixel of compared frames.
ColourFinding colour_finding(const FrameComparison& compared, std::size_t pixel);

/// Records the steps of several pixels.
class PixelEventRecorder final : public EventSink {
public:
    explicit PixelEventRecorder(const std::vector<std::uint32_t>& pixels);
    bool wants(std::uint32_t pixel) override { return events_.contains(pixel); }
    void event(const RayEvent& event) override;
    const PixelEvents& of(std::uint32_t pixel) const { return events_.at(pixel); }

private:
    std::map<std::uint32_t, PixelEvents> events_;
};

}   // namespace rayclock
