#pragma once
// The steps of rays in time, the input of pixel stories and timelines.
#include <array>
#include <cstdint>

#include "model/machine/links.hpp"
#include "model/mem/cache.hpp"
#include "model/scene/whitted.hpp"
#include "sim/view/observe/costs.hpp"

namespace rayclock {

/// Counters of one pipeline since the frame began: refused cycles of each link, and cycles of each cache by
/// outcome. The difference of two such records shows what a ray waited for between them.
struct WaitCounts {
    std::array<std::uint32_t, pipeline_links> refused{};
    std::array<std::array<std::uint32_t, cause_count>, ray_caches> outcomes{};
    /// Length of the unbroken run of refused cycles that ends just before this cycle.
    std::array<std::uint32_t, pipeline_links> run{};
};

/// A transfer of a ray on a link, or a cache's look-up of its request.
struct RayEvent {
    enum class Type : std::uint8_t { transfer, lookup };
    std::uint64_t cycle = 0;   ///< of the frame
    Type type = Type::transfer;
    Link link{};              ///< the link of the transfer; for a look-up, the link of its request
    CacheOutcome outcome{};   ///< for a look-up: hit, miss or merge
    std::uint32_t addr = 0;   ///< address of a request
    int pipeline = 0;
    std::uint32_t context = 0;
    std::uint32_t pixel = 0;   ///< y * width + x
    std::uint32_t ray = 0;     ///< index in its pixel, from 0
    RayPurpose purpose{};
    /// The cycle in which the pixel began. It separates pixels of two frames in the same context.
    std::uint32_t first = 0;
    const WaitCounts* waits = nullptr;   ///< includes this cycle; valid only during the callback
};

/// Returns the unit that holds a ray after its transfer on a link. `streams`: the chip reads rays from
/// memory.
constexpr std::size_t place_after(Link link, bool streams) {
    if (link == Link::slot && streams) return index(Unit::stream);
    for (const NodeUnit& decides : node_units) {
        if (link == decides.req) return index(decides.unit);
        if (link == decides.rsp) return index(Unit::trav);
    }
    switch (link) {
        case Link::slot:
        case Link::record:
        case Link::spawn: return index(Unit::raygen);
        case Link::ray:
        case Link::change:
        case Link::tested: return index(Unit::trav);
        case Link::node_req: return index(Unit::node_cache);
        case Link::xform_req: return index(Unit::xform);
        case Link::leaves:
        case Link::tri_rsp: return index(Unit::list);
        case Link::prim_req: return index(Unit::prim_cache);
        case Link::tri_req: return index(Unit::tri);
        case Link::surf_req: return index(Unit::surf_cache);
        case Link::tex_req:
        case Link::texel_rsp: return index(Unit::tex);
        case Link::texel_req: return index(Unit::tex_cache);
        default: return index(Unit::shade);
    }
}

/// Receives the steps of rays. Cycles arrive in order, and the steps of one cycle in the order of the links.
class EventSink {
public:
    virtual ~EventSink() = default;
    /// Called when the frame begins.
    virtual void begins(const class Machine& machine) { (void)machine; }
    /// Called once for every pixel when it begins; returns true to receive its events.
    virtual bool wants(std::uint32_t pixel) = 0;
    virtual void event(const RayEvent& event) = 0;
    /// Returns true if no later event is needed. Called in every cycle.
    virtual bool done() const { return false; }
    /// Called after the events of every cycle. The machine's `accounts()` cover all cycles up to the next
    /// one.
    virtual void cycle_done(std::uint64_t cycle, const class Machine& machine) { (void)cycle, (void)machine; }
};

}   // namespace rayclock
