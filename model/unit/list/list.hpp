#pragma once
#include "model/core/ring.hpp"

namespace rayclock {

/// The leaves of a node: when. Rays come from trav, with leaves to be tested, and from tri; each waits for
/// the link to prim, where there is a queue for each source, so that neither waits for the other, and tri's
/// rays go first; or its leaves are tested, and it waits for the link to trav. What is asked for is decided
/// by RayTests.
///
/// Leaves and an answer of tri are accepted in every cycle; one triangle of a ray is under way at a time.
/// Mirror of rtl/unit/list/rc_list.sv.
class List {
public:
    explicit List(const Config& config)
        : next_(config.contexts), first_(config.contexts), tested_(config.contexts) {}

    bool prim_valid() const { return !next_.empty() | !first_.empty(); }
    std::uint32_t prim_ray() const {
        const RayNumber first = first_.front(), next = next_.front();
        return select(starting(), first, next);
    }
    bool tested_valid() const { return !tested_.empty(); }
    std::uint32_t tested_ray() const { return tested_.front(); }

    const char* where(std::uint32_t ray) const {
        return next_.contains(RayNumber(ray)) || first_.contains(RayNumber(ray))
                   ? "list: waits for the link to prim_cache"
               : tested_.contains(RayNumber(ray)) ? "list: waits for trav"
                                                  : nullptr;
    }

    /// One clock edge: rays that came with leaves and from tri, whether tri's has another triangle to be
    /// tested, and which outputs were taken.
    void clock(OnLink leaves, OnLink tri, bool tri_prim, bool prim_taken, bool tested_taken) {
        // What leaves, leaves before anything enters: a queue shows a new entry in the next cycle.
        const bool start = starting();
        prim_link_.clock(prim_valid(), prim_taken, start);
        first_.pop(prim_taken & start);
        next_.pop(prim_taken & !start);
        tested_.pop(tested_taken);
        next_.push(RayNumber(tri.ray), tri.there & tri_prim);
        tested_.push(RayNumber(tri.ray), tri.there & !tri_prim);
        first_.push(RayNumber(leaves.ray), leaves.there);
    }

private:
    bool starting() const { return prim_link_.second(!next_.empty()); }

    RayRing next_, first_;   // after tri's answer; first of a node
    RayRing tested_;
    Merge prim_link_;
};

}   // namespace rayclock
