#pragma once
// The steps of rays in time, for those who tell a pixel's story or draw a timeline.
#include <array>
#include <cstdint>

#include "model/core/links.hpp"
#include "model/mem/cache.hpp"
#include "model/scene/whitted.hpp"
#include "sim/view/observe/costs.hpp"

namespace rayclock {

/// Since the frame began, in one pipeline: of each link the cycles in which it was refused, of each cache the
/// cycles by deed. Two of these tell what a ray has waited for between them.
struct WaitCounts {
    std::array<std::uint32_t, pipeline_links> refused{};
    std::array<std::array<std::uint32_t, cause_count>, ray_caches> deeds{};
    std::array<std::uint32_t, pipeline_links> run{};   ///< cycles just before this one in which it was
                                                       ///< refused
};

/// A ray moved on a link, or a cache has looked up its request.
struct RayEvent {
    enum class What : std::uint8_t { moved, looked_up };
    std::uint64_t cycle = 0;   ///< of the frame
    What what = What::moved;
    Link link{};              ///< moved; of a look-up the one that the request came by
    CacheDeed deed{};         ///< of a look-up: hit, miss or merge
    std::uint32_t addr = 0;   ///< of requests
    int pipeline = 0;
    std::uint32_t context = 0;
    std::uint32_t pixel = 0;   ///< y * width + x
    std::uint32_t ray = 0;     ///< of its pixel, from 0
    RayPurpose purpose{};
    std::uint32_t first = 0;   ///< cycle in which the pixel began: tells two frames' pixels in a context
                               ///< apart
    const WaitCounts* waits = nullptr;   ///< this cycle included; only while the event is shown
};

/// The unit in which a ray is after it has moved on a link.
constexpr std::size_t place_after(Link link) {
    for (const NodeUnit& decides : node_units) {
        if (link == decides.req) return index(decides.unit);
        if (link == decides.rsp) return index(Unit::trav);
    }
    switch (link) {
        case Link::slot:
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
        default: return index(Unit::shade);
    }
}

/// Is shown steps of rays. The machine's cycles come in order, the steps of a cycle in the order of links.
class EventSink {
public:
    virtual ~EventSink() = default;
    /// The frame begins.
    virtual void begins(const class Machine& machine) { (void)machine; }
    /// Asked once for every pixel when it begins.
    virtual bool wants(std::uint32_t pixel) = 0;
    virtual void event(const RayEvent& event) = 0;
    /// Nothing that comes later is wanted. Asked in every cycle.
    virtual bool done() const { return false; }
    /// After every cycle's events; `accounts()` of the machine are those up to the next cycle.
    virtual void cycle_done(std::uint64_t cycle, const class Machine& machine) { (void)cycle, (void)machine; }
};

}   // namespace rayclock
