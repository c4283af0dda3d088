#pragma once
// What happened to one pixel, cycle by cycle: where each of its rays was, and what it waited for.
#include <string>
#include <vector>

#include "sim/view/observe/events.hpp"
#include "sim/view/observe/path.hpp"
#include "sim/view/observe/replay.hpp"

namespace rayclock {

/// From one transfer of a ray to its next: cycles in one unit. `work` is what the unit takes if nobody is in
/// the way; the rest was waited for something.
struct Stay {
    std::uint64_t first = 0, cycles = 0;   ///< of the frame
    std::size_t place = 0;                 ///< unit
    Link by{};                             ///< the link by which the ray came
    std::uint32_t addr = 0;                ///< of a cache: the line, or the half line of a primitive
    bool is_lookup = false;
    CacheDeed lookup{};   ///< of a cache
    std::uint64_t work = 0;
    struct Wait {
        std::string cause;
        std::uint64_t cycles = 0;
    };
    std::vector<Wait> waits;   ///< work and waits sum to cycles
};

struct RayStory {
    RayValues values;
    std::uint64_t first = 0, cycles = 0;   ///< from the slot or the spawn to the next spawn or the pixel's
                                           ///< end
    std::vector<Stay> stays;
    std::uint64_t misses = 0, merges = 0;
};

struct PixelStory {
    std::uint32_t x = 0, y = 0;
    int pipeline = 0;
    std::uint32_t context = 0;
    PixelCost cost;
    std::uint64_t alone = 0;   ///< cycles that the pixel takes alone on the chip, with warm caches
    std::vector<RayStory> rays;
    /// All stays together, by unit and by cause; the longest first.
    std::vector<Stay::Wait> places() const;
    std::vector<Stay::Wait> causes() const;
};

/// Keeps the steps of one pixel.
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

/// From the pixel's steps in the frame, and the same pixel's alone on the chip.
PixelStory tell(const Job& job, const FrameTrace& frame, const FrameCosts& costs, const PixelEvents& in_frame,
                const PixelEvents& alone);

}   // namespace rayclock
