// Collects the findings and events of explained pixels.
#include "sim/app/run/pixel_findings.hpp"

#include <fmt/format.h>

namespace rayclock {

ColourFinding colour_finding(const FrameComparison& c, std::size_t pixel) {
    ColourFinding found;
    found.machine = c.picture.pixels[pixel];
    found.reference = c.reference.pixels[pixel];
    found.hit = c.hits.hits[pixel];
    found.reference_hit = c.reference_hits.hits[pixel];
    found.is_other = found.hit.primitive != found.reference_hit.primitive;
    found.stages = c.stages;
    if (!c.judgement) return found;
    found.cause = c.judgement->pixels[pixel];
    for (const PictureFault& fault : c.judgement->faults)
        if (fault.x + std::size_t(fault.y) * std::size_t(c.hits.size.width) == pixel)
            found.fault = fmt::format("ray {}: {}", fault.ray, fault.what);
    return found;
}

PixelEventRecorder::PixelEventRecorder(const std::vector<std::uint32_t>& pixels) {
    for (const std::uint32_t pixel : pixels) events_.emplace(pixel, PixelEvents(pixel));
}
void PixelEventRecorder::event(const RayEvent& event) { events_.at(event.pixel).event(event); }

}   // namespace rayclock
