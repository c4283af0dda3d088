#pragma once
// Observes a machine cycle by cycle and sums the costs of a frame. The machine does not depend on the
// observer.
#include <deque>

#include "model/machine/machine.hpp"
#include "sim/view/observe/costs.hpp"
#include "sim/view/observe/events.hpp"

namespace rayclock {

/// Observes one frame. Call step() for each cycle, then finish() once.
class Observer {
public:
    /// `sink` may be null. A window has `window` cycles; 0 records no windows.
    Observer(const Machine& machine, const Frame& frame, EventSink* sink, std::uint64_t window);

    /// Runs one clock cycle of the machine. The frame must have been started.
    void step(Machine& machine);
    /// Returns the costs. Call it after the last cycle.
    FrameCosts finish(const Machine& machine);

private:
    struct Context {
        std::uint32_t pixel = 0, first = 0, ray = 0;
        std::uint64_t since = 0;   ///< cycle in which the context came to `place`
        std::size_t place = 0;
        RayPurpose purpose{};
        bool in_use = false, watched = false;
        std::uint32_t addr[ray_caches]{};
    };
    /// Requests to a cache, in order.
    struct CacheQueue {
        std::deque<std::uint32_t> requests;   ///< contexts whose look-up is pending
        std::deque<std::uint32_t> missing;    ///< contexts whose missing lines have words to request
        int words = 0;                        ///< words requested of the first missing line
    };
    struct PipelineState {
        std::vector<Context> contexts;
        std::array<CacheQueue, ray_caches> caches;
        WaitCounts waits;
        std::uint32_t in_use = 0;
    };

    /// Returns the tile of a pixel, or the group of a stream's ray.
    TileSpan& tile_of(std::uint32_t pixel);
    void moved(const Move& move);
    void began(PipelineState& p, const Move& move);
    void at(PipelineState& p, Context& context, Link link);
    void looked_up(int pipeline, std::size_t cache, CacheOutcome outcome);
    void asked_memory(PipelineState& p, std::size_t cache);
    void shared(const Machine& machine);
    void count_runs(const Machine& machine);
    void close_window(const Machine& machine);
    void show(int pipeline, std::uint32_t context, RayEvent::Type what, Link link, CacheOutcome outcome,
              std::uint32_t addr);
    PixelCost& cost(const Context& c) { return costs_.pixels[c.pixel]; }
    PurposeCost& purpose(const Context& c) { return costs_.purposes[std::size_t(c.purpose)]; }
    void pay(std::uint32_t owner_pixel, RayPurpose purpose);

    const Machine& machine_;
    EventSink* sink_;
    std::uint64_t start_;   ///< the machine's cycle when the frame began
    std::uint64_t now_ = 0;
    std::uint64_t window_;
    int tile_bits_;
    bool has_l2_;
    std::size_t caches_;   ///< that serve rays
    bool lists_, streams_;
    std::uint32_t records_;   ///< line of the stream's first two rays
    std::array<int, ray_caches> line_words_;
    std::vector<PipelineState> pipelines_;
    std::vector<std::int32_t> tile_spans_;   ///< [tile]: index in costs_.tiles
    std::uint32_t tile_columns_;
    /// The pixel and the purpose of the request on the shared link.
    struct Owner {
        std::uint32_t pixel = 0;
        RayPurpose purpose{};
    } owner_;
    std::deque<Owner> l2_requests_, l2_missing_;
    int l2_words_ = 0, l2_line_words_ = 1;
    std::vector<RayEvent> pending_;   ///< events of this cycle
    Window open_;
    Accounts accounts_;   ///< accounts before the frame
    MemoryStats memory_;
    FrameCosts costs_;
};

}   // namespace rayclock
