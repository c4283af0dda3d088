#pragma once
#include "model/base/ring.hpp"

namespace rayclock {

/// The leaves of a node: when. Rays come from box and from tri; each goes to one of two links, prim (a
/// triangle is to be tested) or step (on to trav), and there is a queue for each source and link, so that
/// neither waits for the other; on a link tri's rays go first. What is asked for is decided by Leaves.
///
/// An answer of box and one of tri are accepted in every cycle; one triangle of a ray is under way at a time.
/// Mirror of rtl/list/rc_list.sv.
class List {
public:
    explicit List(const Config& config)
        : next_(config.contexts),
          first_(config.contexts),
          tested_(config.contexts),
          leafless_(config.contexts) {}

    bool prim_valid() const { return !next_.empty() || !first_.empty(); }
    std::uint32_t prim_ray() const { return starting() ? first_.front() : next_.front(); }
    bool step_valid() const { return !tested_.empty() || !leafless_.empty(); }
    std::uint32_t step_ray() const { return leaving() ? leafless_.front() : tested_.front(); }

    const char* where(std::uint32_t ray) const {
        return next_.contains(RayNumber(ray)) || first_.contains(RayNumber(ray))
                   ? "list: waits for the link to prim_cache"
               : tested_.contains(RayNumber(ray)) || leafless_.contains(RayNumber(ray))
                   ? "list: waits for trav"
                   : nullptr;
    }

    /// One clock edge: rays that came from box and from tri (null if none), whether each has a triangle to be
    /// tested, and which outputs were taken.
    void clock(const std::uint32_t* box, bool box_prim, const std::uint32_t* tri, bool tri_prim,
               bool prim_taken, bool step_taken) {
        // What leaves, leaves before anything enters: a queue shows a new entry in the next cycle.
        const bool start = starting(), leave = leaving();
        prim_link_.clock(prim_valid(), prim_taken, start);
        step_link_.clock(step_valid(), step_taken, leave);
        if (prim_taken) (start ? first_ : next_).pop();
        if (step_taken) (leave ? leafless_ : tested_).pop();
        if (tri) (tri_prim ? next_ : tested_).push(RayNumber(*tri));
        if (box) (box_prim ? first_ : leafless_).push(RayNumber(*box));
    }

private:
    bool starting() const { return prim_link_.second(!next_.empty()); }
    bool leaving() const { return step_link_.second(!tested_.empty()); }

    RayRing next_, first_;        // after tri's answer; first of a node
    RayRing tested_, leafless_;   // after tri's answer; straight from box
    Merge prim_link_, step_link_;
};

}   // namespace rayclock
