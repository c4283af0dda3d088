#pragma once
// The story of one pixel, cycle by cycle: the place of each ray and what it waited for.
#include <string>
#include <vector>

#include "sim/view/observe/events.hpp"
#include "sim/view/observe/path.hpp"
#include "sim/view/observe/replay.hpp"

namespace rayclock {

/// The time from one transfer of a ray to its next, spent in one unit. `work` is the time that the unit needs
/// without interference. The other cycles are waits.
struct Stay {
    std::uint64_t first = 0, cycles = 0;   ///< cycles of the frame
    std::size_t place = 0;                 ///< unit
    Link by{};                             ///< the link by which the ray came
    std::uint32_t addr = 0;                ///< for a cache: the line, or the half line of a primitive
    bool is_lookup = false;
    CacheOutcome lookup{};   ///< for a cache
    std::uint64_t work = 0;
    struct Wait {
        std::string cause;
        std::uint64_t cycles = 0;
    };
    std::vector<Wait> waits;   ///< work and waits sum to cycles
};

/// The stays of one ray.
struct RayStory {
    RayValues values;
    /// From the slot or the spawn to the next spawn or to the end of the pixel.
    std::uint64_t first = 0, cycles = 0;
    std::vector<Stay> stays;
    std::uint64_t misses = 0, merges = 0;
};

/// The rays of one pixel and their times.
struct PixelStory {
    std::uint32_t x = 0, y = 0;
    int pipeline = 0;
    std::uint32_t context = 0;
    PixelCost cost;
    std::uint64_t alone = 0;   ///< cycles of the pixel alone on the chip with warm caches
    std::vector<RayStory> rays;
    /// Sums of all stays by unit and by cause, the longest first.
    std::vector<Stay::Wait> places() const;
    std::vector<Stay::Wait> causes() const;
};

/// Stores the steps of one pixel.
class PixelEvents final : public EventSink {
public:
    explicit PixelEvents(std::uint32_t pixel) : pixel_(pixel) {}
    bool wants(std::uint32_t pixel) override { return pixel == pixel_; }
    void event(const RayEvent& event) override {
        events.push_back(event);
        waits.push_back(*event.waits);
    }
    std::vector<RayEvent> events;
    std::vector<WaitCounts> waits;   ///< of each event

private:
    std::uint32_t pixel_;
};

/// Builds the story from the pixel's events in the frame and from its events alone on the chip.
PixelStory make_story(const Job& job, const RecordedFrame& frame, const FrameCosts& costs,
                      const PixelEvents& in_frame, const PixelEvents& alone);

}   // namespace rayclock
