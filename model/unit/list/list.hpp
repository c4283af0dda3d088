#pragma once
// The unit list in time. ray_tests.hpp has its decisions.
#include "model/core/ring.hpp"

namespace rayclock {

/// The unit list in time. Rays arrive from trav, with leaves to test, and from tri. Each one either waits for
/// the link to prim_cache or, if its leaves are tested, for the link to trav. The link to prim_cache has a
/// queue for each source, so that neither source blocks the other; tri's rays have priority. RayTests decides
/// the requests.
///
/// It accepts leaves and an answer of tri in every cycle. One triangle of a ray is in flight at a time.
/// Mirror of rtl/unit/list/rc_list.sv.
class List {
public:
    explicit List(const Config& config)
        : next_(config.contexts), first_(config.contexts), tested_(config.contexts) {}

    bool prim_valid() const { return !next_.empty() | !first_.empty(); }
    template <bool few = false> std::uint32_t prim_ray() const {
        const RayNumber first = first_.front<few>(), next = next_.front<few>();
        return select(starting(), first, next);
    }
    bool tested_valid() const { return !tested_.empty(); }
    template <bool few = false> std::uint32_t tested_ray() const { return tested_.front<few>(); }

    const char* where(std::uint32_t ray) const {
        return next_.contains(RayNumber(ray)) || first_.contains(RayNumber(ray))
                   ? "list: waits for the link to prim_cache"
               : tested_.contains(RayNumber(ray)) ? "list: waits for trav"
                                                  : nullptr;
    }

    /// One clock edge of the queues before prim_cache. `leaves`, `next`: the rays that arrived with leaves,
    /// and from tri with another triangle to test. `prim_taken`: the output was accepted.
    template <bool few = false> void clock_prims(LinkRay leaves, LinkRay next, bool prim_taken) {
        // Pops come before pushes: a queue shows a new entry in the next cycle.
        const bool start = starting();
        prim_link_.clock(prim_valid(), prim_taken, start);
        first_.pop(prim_taken & start);
        next_.pop(prim_taken & !start);
        next_.push<few>(RayNumber(next.ray), next.valid);
        first_.push<few>(RayNumber(leaves.ray), leaves.valid);
    }
    /// One clock edge of the queue before trav. `tested`: the ray that arrived from tri with its last
    /// triangle. `taken`: the output was accepted.
    template <bool few = false> void clock_tested(LinkRay tested, bool taken) {
        tested_.pop(taken);
        tested_.push<few>(RayNumber(tested.ray), tested.valid);
    }

private:
    bool starting() const { return prim_link_.second(!next_.empty()); }

    RayRing next_, first_;   // after tri's answer; first of a node
    RayRing tested_;
    Merge prim_link_;
};

}   // namespace rayclock
